/// \file Sets of numbers that grow together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace qm {

/// The numbers from 0 on, each in a set of its own at first. A set is known by its lowest number.
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

    /// Puts a number into a set of its own again, as all others of its set must be before any is asked for.
    void isolate(std::size_t k) { parent_[k] = k; }

private:
    std::vector<std::size_t> parent_;
};

} // namespace qm
