/// \file All motorcycle graphs of a problem as one decision diagram (docs/METHOD.md#decision-diagrams, as in
/// docs/METHOD.md#bryant-1986): every
/// path from its root to its end is one graph, so that they can be counted, drawn, listed and ranked without
/// being searched for again.
#pragma once

#include "base/control.h"
#include "enumerate/state/assignment.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace qm {

struct Diagram {
    using NodeId = std::uint32_t;
    static constexpr NodeId none = 0; ///< no graph is this way
    static constexpr NodeId end = 1;

    /// A decision. Nodes follow their successors.
    struct Node {
        VariableId variable; ///< none if only the cover of a line is decided, which the arcs show as well
        NodeId in = none;
        NodeId out = none;
        double cost = 0; ///< what the variable adds when it is in
    };
    std::vector<Node> nodes; ///< the first two stand for `none` and `end`
    NodeId root = none;
    Assignment fixed; ///< values of the variables that are the same in every graph; the others are 0
    double fixedCost = 0;
};

/// What a search may spend on a diagram: about a gigabyte.
constexpr std::size_t diagramNodes = 10'000'000;

/// What it may spend on one where it can do without.
constexpr std::size_t smallDiagram = 1'000'000;

/// Decides step by step (elimination_order.h); two paths after which the same remains to be decided meet in
/// one node, as in frontier-based search (docs/METHOD.md#sekine-1995,
/// docs/METHOD.md#knuth-2011, docs/METHOD.md#kawahara-2017). What remains can be told from the
/// border between decided and undecided crossings alone, so that the number of nodes depends on the width of
/// that border and not on the number of graphs.
/// `maxNodes` bounds the memory: 100 bytes per node, roughly, while it is built.
/// \return nothing if there would be more than `maxNodes` nodes or `control.stopRequested`
[[nodiscard]] std::optional<Diagram> buildDiagram(const Problem& problem, std::size_t maxNodes,
                                                  const Control& control = {});

} // namespace qm
