/// \file Sets of numbers that grow together, where few of very many numbers do.
#pragma once

#include <unordered_map>
#include <utility>

namespace qm {

/// Any numbers, each in a set of its own at first; memory depends on those that have been joined.
class SparseDisjointSets {
public:
    /// A member that is the same for all of a set until the set grows.
    [[nodiscard]] int find(int member) {
        int root = member;
        for (auto up = parent_.find(root); up != parent_.end(); up = parent_.find(root))
            root = up->second;
        while (member != root)
            member = std::exchange(parent_[member], root);
        return root;
    }

    /// \return false if both were in one set already
    bool join(int a, int b) {
        const int from = find(a), to = find(b);
        if (from != to) parent_[from] = to;
        return from != to;
    }

private:
    std::unordered_map<int, int> parent_; ///< of all but the roots
};

} // namespace qm
