#include "layout/cost.h"

#include "base/at.h"
#include "base/error.h"

#include <cmath>

namespace qm {
namespace {

/// Searches add costs of edges and of segments, of which there are no more than edges, in any order.
void requireFiniteSums(const std::vector<double>& costs, double costOfSegment) {
    constexpr double largest = 1e300;
    double sum = std::abs(costOfSegment) * static_cast<double>(costs.size());
    for (const double cost : costs)
        sum += std::abs(cost);
    if (!(sum < largest))
        throw Error("", "what edges and segments cost is too much to be added up",
                    "Take smaller numbers for --alpha, --cost and weights under /constraints");
}

} // namespace

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
    requireFiniteSums(costs, cost.terms.segments);
    return costs;
}

} // namespace qm
