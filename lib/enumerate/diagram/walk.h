/// \file Visiting every path of a decision diagram, without a search and without dead ends.
#pragma once

#include "enumerate/diagram/cheapest_graph.h"

#include <cmath>
#include <utility>
#include <vector>

namespace qm {

/// Calls `visit` with every graph that costs at most `maxCost`; parts of the diagram without such graphs are
/// skipped.
/// \return false if `visit` returned false, which ends the walk
template <class Visit> bool walkDiagram(const Diagram& diagram, double maxCost, Visit& visit) {
    Assignment assignment = diagram.fixed;
    const bool isLimited = std::isfinite(maxCost);
    const std::vector<double> cheapest = isLimited ? cheapestPaths(diagram) : std::vector<double>();
    const auto walk = [&](const auto& self, Diagram::NodeId id, double left) -> bool {
        if (id == Diagram::none || (isLimited && cheapest[id] > left)) return true;
        if (id == Diagram::end) return visit(std::as_const(assignment));
        const Diagram::Node& node = diagram.nodes[id];
        const auto decide = [&](signed char value) {
            if (node.variable.valid()) assignment[node.variable] = value;
        };
        decide(1);
        if (!self(self, node.in, left - node.cost)) return false;
        decide(0);
        return self(self, node.out, left);
    };
    return walk(walk, diagram.root, maxCost - diagram.fixedCost);
}

} // namespace qm
