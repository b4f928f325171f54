/// \file Union-find over many numbers of which few are ever joined.
#pragma once

#include <unordered_map>
#include <utility>

namespace qm {

/// Any numbers, at first each in a set of its own; memory is linear in the numbers that have been joined.
class SparseDisjointSets {
public:
    /// A representative of the member's set, which may change when the set grows.
    [[nodiscard]] int find(int member) {
        int root = member;
        for (auto up = parent_.find(root); up != parent_.end(); up = parent_.find(root))
            root = up->second;
        while (member != root)
            member = std::exchange(parent_[member], root);
        return root;
    }

    /// The representative of b becomes that of both.
    /// \return false if both are in one set already
    bool join(int a, int b) {
        const int from = find(a), to = find(b);
        if (from != to) parent_[from] = to;
        return from != to;
    }

private:
    std::unordered_map<int, int> parent_; ///< parent of every member except roots
};

} // namespace qm
