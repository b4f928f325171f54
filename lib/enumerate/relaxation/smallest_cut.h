/// \file The smallest cut between two nodes of a small directed graph, by the algorithm of Dinitz
/// (docs/METHOD.md#dinitz-1970).
#pragma once

#include <cstddef>
#include <vector>

namespace qm {

class SmallestCut {
public:
    explicit SmallestCut(std::size_t nodes) : edgesOf_(nodes) {}

    void addEdge(std::size_t from, std::size_t to, double capacity);
    void find(std::size_t source, std::size_t sink);
    /// Whether a node is on the source's side of the cut; to be called after `find`.
    [[nodiscard]] bool isBefore(std::size_t node) const { return levels_[node] >= 0; }

private:
    struct Edge {
        std::size_t to;
        double left; ///< remaining capacity
    };
    void findLevels(std::size_t source);
    double push(std::size_t node, std::size_t sink, double max);

    std::vector<std::vector<std::size_t>> edgesOf_; ///< the edges of every node
    std::vector<Edge> edges_;                       ///< every edge is followed by its reverse
    std::vector<int> levels_;       ///< steps from the source; negative for nodes that it cannot reach
    std::vector<std::size_t> next_; ///< of every node, the first of its edges that may still carry flow
};

} // namespace qm
