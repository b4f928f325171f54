/// \file A partition of numbers whose sets can be joined: union-find.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace qm {

/// The numbers from 0 on, at first each in a set of its own. A set is represented by its lowest number.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    [[nodiscard]] std::size_t find(std::size_t k) {
        while (parent_[k] != k)
            k = parent_[k] = parent_[parent_[k]];
        return k;
    }

    void join(std::size_t a, std::size_t b) {
        const auto [low, high] = std::minmax({find(a), find(b)});
        parent_[high] = low;
    }

    /// The members of every set, ascending; sets in the order of their lowest members.
    [[nodiscard]] std::vector<std::vector<std::size_t>> members() {
        std::vector<std::vector<std::size_t>> sets(parent_.size());
        for (std::size_t k = 0; k < sets.size(); ++k)
            sets[find(k)].push_back(k);
        std::erase_if(sets, [](const auto& set) { return set.empty(); });
        return sets;
    }

    /// Puts a number back into a set of its own. All other members of its old set must be isolated, too,
    /// before `find` is called for any of them.
    void isolate(std::size_t k) { parent_[k] = k; }

private:
    std::vector<std::size_t> parent_;
};

} // namespace qm
