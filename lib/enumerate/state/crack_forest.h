/// \file Rule 4 (docs/METHOD.md#cracks): every crossing needs a head-on meeting on one of its two lines.
#pragma once

#include <vector>

namespace qm {

/// Keeps, for groups of lines joined by crossings, how many head-on meetings they have left. Union by size
/// without path compression, so that the last change can be taken back.
class CrackForest {
public:
    explicit CrackForest(std::vector<int> capacities);

    /// Enters a crossing between two lines that can be cracked, or, with a == b, one that line a must crack.
    /// \return false if no meeting is left for it; the change is made all the same and must be undone
    bool cross(int a, int b);

    /// A representative of the line's group.
    [[nodiscard]] int find(int node) const;

    /// Head-on meetings that a group, named by its representative, has left.
    [[nodiscard]] int left(int root) const { return left_[static_cast<std::size_t>(root)]; }

    [[nodiscard]] std::size_t changes() const { return trail_.size(); }
    void undo(std::size_t changes);

private:
    struct Change {
        int child; ///< joined to root; -1 if both were in one group already
        int root;
    };
    std::vector<int> parent_;
    std::vector<int> size_;
    std::vector<int> left_; ///< of a root: lines in the group less crossings
    std::vector<Change> trail_;
};

} // namespace qm
