/// \file Two-way minimum cut of weighted nodes (docs/METHOD.md#mesh-cut) by the algorithm of Boykov and
/// Kolmogorov (docs/METHOD.md#boykov-2004), after what is certain has been fixed.
#pragma once

#include <array>
#include <vector>

namespace qm {

/// Minimise sum of the labels' costs plus the capacities of edges whose ends differ.
struct CutProblem {
    struct Edge {
        int a;
        int b;
        double capacity;
    };
    std::vector<std::array<double, 2>> costs; ///< of every node: for label 0 (source) and label 1 (sink)
    std::vector<Edge> edges;
};

/// An optimal label of every node. A node whose preference for a label outweighs all its edges has that label
/// in every optimum. Such nodes are fixed first, which adds to their neighbours' preferences, so that only a
/// band remains for the flow.
[[nodiscard]] std::vector<int> minimumCut(const CutProblem& problem);

} // namespace qm
