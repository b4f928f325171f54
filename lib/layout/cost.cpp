#include "layout/cost.h"

#include "base/at.h"
#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

/// Searches tell sums of costs apart that differ by a small number, and linear programs cannot be solved with
/// huge costs.
void requireExactSums(const std::vector<double>& costs, double costOfSegment) {
    constexpr double largest = 1e15; // above it doubles have less than one decimal
    // There are fewer segments than edges.
    double sum = std::abs(costOfSegment) * static_cast<double>(costs.size());
    for (const double cost : costs)
        sum += std::abs(cost);
    if (!(sum <= largest))
        throw Error("", "what edges and segments cost adds up to more than 1e15, too much to tell sums apart",
                    "Take smaller numbers for --alpha, --cost and weights under /constraints");
}

/// Adds the term of the edges' lengths to the costs.
void addLengths(const QuadMesh& mesh, double factor, std::vector<double>& costs) {
    constexpr double minLength = 1e-5; // a hundred times the smallest difference that searches tell apart
    double longest = 0;
    for (const EdgeId edge : mesh.edges()) {
        if (mesh.is_boundary(edge)) continue;
        const double length = mesh.calc_edge_length(edge);
        costs[at(edge)] += factor * length;
        longest = std::max(longest, length);
    }
    if (longest > 0 && std::abs(factor) * longest < minLength)
        throw Error("", "what edges cost by their lengths is below 1e-5, too little to tell layouts apart",
                    "Take a larger number before length in --cost");
}

} // namespace

std::vector<double> edgeCosts(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                              const GraphCost& cost, const Constraints& constraints) {
    std::vector<double> costs = edgeCosts(dihedralAngles, cost);
    if (cost.terms.dihedral != 1)
        for (double& each : costs)
            each *= cost.terms.dihedral;
    if (cost.terms.length != 0) addLengths(mesh, cost.terms.length, costs);
    for (const auto& [edge, weight] : constraints.weights)
        costs[at(edge)] += cost.terms.custom * weight;
    requireExactSums(costs, cost.terms.segments);
    return costs;
}

} // namespace qm
