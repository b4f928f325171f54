/// \file Dihedral angles and edge costs, computed anew (docs/METHOD.md#cost).
#pragma once

#include "base/at.h"
#include "check/document/checked_document.h"
#include "check/mesh/neighbourhoods.h"

#include <vector>

namespace qm::check {

/// By edge.
struct Angles {
    /// Unsigned dihedral angle, radians; 0 on the boundary and beside a face without a normal.
    std::vector<double> angle;
    /// By how much rounding may change it: pi beside a face whose normal is what cancellation left, else 0.
    std::vector<double> doubt;
};
[[nodiscard]] Angles dihedralAngles(const CheckedMesh& mesh, const Neighbourhoods& around);

/// Cost of every edge.
struct EdgeCosts {
    std::vector<double> cost; ///< -theta, + alpha if theta < epsilon
    /// By how much rounding may change it; |alpha| more for an angle that equals epsilon but for the last
    /// digits.
    std::vector<double> doubt;
};
[[nodiscard]] EdgeCosts edgeCosts(const Angles& angles, double alpha, double epsilon);

/// The same with all terms of the cost but the segments.
[[nodiscard]] EdgeCosts edgeCosts(const CheckedMesh& mesh, const Neighbourhoods& around, const Angles& angles,
                                  const CostWeights& weights, const ConstraintsPart& constraints);

/// A sum over edges, to be compared with a figure of the document.
class CostSum {
public:
    explicit CostSum(const EdgeCosts& costs) : costs_(costs) {}
    void add(int edge) {
        cost_ += costs_.cost[at(edge)];
        doubt_ += costs_.doubt[at(edge)];
    }
    void add(const CostSum& other) {
        cost_ += other.cost_;
        doubt_ += other.doubt_;
    }
    void addCost(double cost) { cost_ += cost; }
    [[nodiscard]] double value() const { return cost_; }
    /// Equal to 1e-6, relative for large sums.
    [[nodiscard]] bool equals(double claimed) const;

private:
    const EdgeCosts& costs_;
    double cost_ = 0;
    double doubt_ = 0;
};

} // namespace qm::check
