/// \file Two-way minimum cut of weighted nodes (docs/METHOD.md#mesh-cut) by the algorithm of Boykov and
/// Kolmogorov (docs/METHOD.md#boykov-2004), after fixing all nodes whose label is certain.
#pragma once

#include <array>
#include <vector>

namespace qm {

/// Minimise the sum of the labels' costs and of the capacities of all edges whose ends have different labels.
struct CutProblem {
    struct Edge {
        int a;
        int b;
        double capacity;
    };
    std::vector<std::array<double, 2>> costs; ///< of every node, for label 0 (source) and label 1 (sink)
    std::vector<Edge> edges;
};

/// Returns an optimal label for every node. A node whose preference for a label outweighs all its edges has
/// that label in every optimum. Such nodes are fixed first, which adds to their neighbours' preferences, so
/// that only a band of nodes remains for the flow.
[[nodiscard]] std::vector<int> minimumCut(const CutProblem& problem);

} // namespace qm
