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
    /// \return the cut's capacity
    double find(std::size_t source, std::size_t sink);
    /// On the source's side; after `find`.
    [[nodiscard]] bool isBefore(std::size_t node) const { return levels_[node] >= 0; }

private:
    struct Edge {
        std::size_t to;
        double left; ///< of its capacity
    };
    void findLevels(std::size_t source);
    double push(std::size_t node, std::size_t sink, double max);

    std::vector<std::vector<std::size_t>> edgesOf_; ///< of every node
    std::vector<Edge> edges_;                       ///< each followed by its reverse
    std::vector<int> levels_;                       ///< steps from the source; negative where it cannot get
    std::vector<std::size_t> next_; ///< of every node, the first edge that may still carry more
};

} // namespace qm
