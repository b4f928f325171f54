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

/// An optimal label of every node. A node that prefers one label by more than all its edges can outweigh has
/// it in every optimum; it is fixed first, and its neighbours feel it, so that only a band remains for the
/// flow.
[[nodiscard]] std::vector<int> minimumCut(const CutProblem& problem);

} // namespace qm
