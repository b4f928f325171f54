/// \file A directed graph without loops that grows edge by edge (docs/METHOD.md#pearce-2006).
#pragma once

#include <cstddef>
#include <vector>

namespace qm {

/// Keeps its nodes in a topological order, of which an edge changes no more than the stretch between its
/// ends.
class AcyclicGraph {
public:
    explicit AcyclicGraph(std::size_t nodes);

    /// \return false if the edge would close a loop; then it is left out
    bool add(std::size_t from, std::size_t to);

private:
    bool collectAfter(std::size_t first, std::size_t forbidden);
    void collectBefore(std::size_t last, std::size_t first);
    void reorder();

    std::vector<std::size_t> rank_; ///< of every node; edges lead to higher ones
    std::vector<std::vector<std::size_t>> next_;
    std::vector<std::vector<std::size_t>> last_;
    std::vector<std::size_t> seen_; ///< of every node, the number of the edge that it was last looked at for
    std::size_t edge_ = 0;
    std::vector<std::size_t> after_;  ///< nodes after the edge's end that stand before its beginning
    std::vector<std::size_t> before_; ///< nodes before its beginning that stand after its end
};

} // namespace qm
