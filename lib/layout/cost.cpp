#include "layout/cost.h"

#include "base/at.h"

namespace qm {

std::vector<double> edgeCosts(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                              const GraphCost& cost, const Constraints& constraints) {
    std::vector<double> costs = edgeCosts(dihedralAngles, cost);
    if (cost.terms.dihedral != 1)
        for (double& each : costs)
            each *= cost.terms.dihedral;
    if (cost.terms.length != 0)
        for (const EdgeId edge : mesh.edges())
            if (!mesh.is_boundary(edge))
                costs[at(edge.idx())] += cost.terms.length * mesh.calc_edge_length(edge);
    for (const auto& [edge, weight] : constraints.weights)
        costs[at(edge.idx())] += cost.terms.custom * weight;
    return costs;
}

} // namespace qm
