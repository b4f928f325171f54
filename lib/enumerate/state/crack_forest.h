/// \file Rule 4 (docs/METHOD.md#cracks): every crossing needs a head-on meeting on one of its two lines.
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

/// Groups lines that are joined by crossings, and keeps the number of head-on meetings that each group has
/// left. Union by size without path compression, so that the last change can be undone.
class CrackForest {
public:
    explicit CrackForest(IdVector<CrackNodeId, int> capacities);

    /// Adds a crossing that must be cracked by line a or by line b; if a == b, only line a can crack it.
    /// \return false if the group has no meeting left for it; the change is made all the same and must be
    /// undone
    bool cross(CrackNodeId a, CrackNodeId b);

    /// The representative of the group that a line belongs to.
    [[nodiscard]] CrackNodeId find(CrackNodeId node) const;

    /// The number of head-on meetings left to a group, which is named by its representative.
    [[nodiscard]] int left(CrackNodeId root) const { return left_[root]; }

    [[nodiscard]] std::size_t changes() const { return trail_.size(); }
    void undo(std::size_t changes);

private:
    struct Change {
        CrackNodeId child; ///< now below root; none if both lines were in one group already
        CrackNodeId root;
    };
    IdVector<CrackNodeId, CrackNodeId> parent_;
    IdVector<CrackNodeId, int> size_;
    IdVector<CrackNodeId, int> left_; ///< of a root: sum of the capacities less the number of crossings
    std::vector<Change> trail_;
};

} // namespace qm
