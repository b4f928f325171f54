/// \file A directed graph that grows edge by edge and stays free of cycles.
#pragma once

#include <cstddef>
#include <vector>

namespace qm {

class AcyclicGraph {
public:
    explicit AcyclicGraph(std::size_t nodes) : next_(nodes), seen_(nodes, 0) {}

    /// Adds an edge.
    /// \return false if the edge would close a cycle; then it is not added
    bool add(std::size_t from, std::size_t to);

private:
    [[nodiscard]] bool reaches(std::size_t first, std::size_t wanted);

    std::vector<std::vector<std::size_t>> next_;
    std::vector<std::size_t> seen_; ///< of every node, the number of the last search that reached it
    std::size_t search_ = 0;
};

} // namespace qm
