/// \file Visiting every path of a decision diagram, without a search and without dead ends.
#pragma once

#include "enumerate/diagram/cheapest_graph.h"

#include <cmath>
#include <utility>
#include <vector>

namespace qm {

/// Calls `visit` with an assignment for every path from a node to the end. Variables that are decided above
/// the node keep their values.
/// \return false if `visit` returned false, which ends the walk
template <class Visit>
bool walkDiagram(const Diagram& diagram, Diagram::NodeId from, Assignment& assignment, Visit& visit) {
    if (from == Diagram::none) return true;
    if (from == Diagram::end) return visit(std::as_const(assignment));
    const Diagram::Node& node = diagram.nodes[from];
    const auto decide = [&](signed char value) {
        if (node.variable.valid()) assignment[node.variable] = value;
    };
    if (node.in != Diagram::none) {
        decide(1);
        if (!walkDiagram(diagram, node.in, assignment, visit)) return false;
    }
    if (node.out == Diagram::none) return true;
    decide(0);
    return walkDiagram(diagram, node.out, assignment, visit);
}

/// The same for all graphs that cost at most `maxCost`; parts of the diagram without such graphs are skipped.
template <class Visit> bool walkDiagramUpTo(const Diagram& diagram, double maxCost, Visit& visit) {
    Assignment assignment = diagram.fixed;
    if (std::isinf(maxCost)) return walkDiagram(diagram, diagram.root, assignment, visit);
    const std::vector<double> cheapest = cheapestPaths(diagram);
    const auto walk = [&](const auto& self, Diagram::NodeId id, double left) -> bool {
        if (cheapest[id] > left) return true;
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
