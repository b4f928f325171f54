/// \file All motorcycle graphs of a problem as one decision diagram (docs/METHOD.md#decision-diagrams,
/// docs/METHOD.md#bryant-1986). Every path from its root to its end is one graph, so graphs can be counted,
/// drawn, listed and ranked without another search.
#pragma once

#include "base/control.h"
#include "enumerate/state/assignment.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace qm {

struct Diagram {
    using NodeId = std::uint32_t;
    static constexpr NodeId none = 0; ///< leads to no graph
    static constexpr NodeId end = 1;

    /// A decision. Nodes come after their successors.
    struct Node {
        /// None if the node decides the cover of a chain, which follows from the variables.
        VariableId variable;
        NodeId in = none;
        NodeId out = none;
        double cost = 0; ///< added if the variable is in
    };
    std::vector<Node> nodes; ///< the first two entries stand for `none` and `end`
    NodeId root = none;
    Assignment fixed; ///< values of the variables that agree in all graphs; all others are 0
    double fixedCost = 0;
};

/// The graph of the path from the root to the end that goes where `isIn(node id)` says; there must be one.
template <class IsIn> [[nodiscard]] Assignment graphAlong(const Diagram& diagram, const IsIn& isIn) {
    Assignment graph = diagram.fixed;
    for (Diagram::NodeId id = diagram.root; id > Diagram::end;) {
        const Diagram::Node& node = diagram.nodes[id];
        const bool in = isIn(id);
        if (node.variable.valid()) graph[node.variable] = in ? 1 : 0;
        id = in ? node.in : node.out;
    }
    return graph;
}

/// Largest number of nodes of a diagram that a search cannot do without: about a gigabyte.
constexpr std::size_t diagramNodes = 10'000'000;

/// Largest number of nodes of a diagram that a search can do without.
constexpr std::size_t smallDiagram = 1'000'000;

/// Decides step by step (elimination_order.h). Two paths after which the same remains to be decided meet in
/// one node, as in frontier-based search (docs/METHOD.md#sekine-1995, docs/METHOD.md#knuth-2011,
/// docs/METHOD.md#kawahara-2017). What remains depends on the border between decided and undecided crossings
/// alone, so the number of nodes depends on the width of that border and not on the number of graphs.
/// `maxNodes` bounds the memory, which is about 100 bytes per node during construction.
/// \return nothing if there would be more than `maxNodes` nodes, or if `control.stopRequested` ended it
[[nodiscard]] std::optional<Diagram> buildDiagram(const Problem& problem, std::size_t maxNodes,
                                                  const Control& control = {});

} // namespace qm
