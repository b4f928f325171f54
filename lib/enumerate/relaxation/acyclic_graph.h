/// \file A directed graph that grows edge by edge and stays free of cycles (docs/METHOD.md#pearce-2006).
#pragma once

#include <cstddef>
#include <vector>

namespace qm {

/// Keeps its nodes in a topological order; a new edge changes the order only between its two ends.
class AcyclicGraph {
public:
    explicit AcyclicGraph(std::size_t nodes);

    /// Adds an edge.
    /// \return false if the edge would close a cycle; then it is not added
    bool add(std::size_t from, std::size_t to);

private:
    bool collectAfter(std::size_t first, std::size_t forbidden);
    void collectBefore(std::size_t last, std::size_t first);
    void reorder();

    std::vector<std::size_t> rank_; ///< of every node; edges lead to higher ranks
    std::vector<std::vector<std::size_t>> next_;
    std::vector<std::vector<std::size_t>> previous_;
    std::vector<std::size_t> seen_; ///< of every node, the number of the last edge whose insertion visited it
    std::size_t edge_ = 0;
    std::vector<std::size_t> after_;  ///< nodes reached from the new edge's end that rank below its beginning
    std::vector<std::size_t> before_; ///< nodes that reach the new edge's beginning and rank above its end
};

} // namespace qm
