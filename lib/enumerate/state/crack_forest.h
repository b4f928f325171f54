/// \file Rule 4 (docs/METHOD.md#cracks): every crossing needs a head-on meeting on one of its two lines.
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

/// Keeps, for groups of lines joined by crossings, how many head-on meetings they have left. Union by size
/// without path compression, so that the last change can be taken back.
class CrackForest {
public:
    explicit CrackForest(IdVector<CrackNodeId, int> capacities);

    /// Enters a crossing between two lines that can be cracked, or, with a == b, one that line a must crack.
    /// \return false if no meeting is left for it; the change is made all the same and must be undone
    bool cross(CrackNodeId a, CrackNodeId b);

    /// A representative of the line's group.
    [[nodiscard]] CrackNodeId find(CrackNodeId node) const;

    /// Head-on meetings that a group, named by its representative, has left.
    [[nodiscard]] int left(CrackNodeId root) const { return left_[root]; }

    [[nodiscard]] std::size_t changes() const { return trail_.size(); }
    void undo(std::size_t changes);

private:
    struct Change {
        CrackNodeId child; ///< joined to root; none if both were in one group already
        CrackNodeId root;
    };
    IdVector<CrackNodeId, CrackNodeId> parent_;
    IdVector<CrackNodeId, int> size_;
    IdVector<CrackNodeId, int> left_; ///< of a root: lines in the group less crossings
    std::vector<Change> trail_;
};

} // namespace qm
