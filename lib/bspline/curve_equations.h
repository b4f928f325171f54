/// \file Least squares for a curve's control points, with conditions.
#pragma once

#include "mesh/quad_mesh.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Weights of four successive control points.
using CurveWeights = std::array<double, 4>;

/// Normal equations, solved by multipliers. A metric, symmetric and positive semi-definite, says how much an
/// error counts in which direction.
class CurveEquations {
public:
    explicit CurveEquations(std::size_t points);

    /// A combination of control points, from `first` on, should be near a target.
    void add(std::size_t first, const CurveWeights& weights, const Eigen::Matrix3d& metric,
             const Point& target);
    /// What no other term determines should be near a target.
    void pull(std::size_t point, const Point& target);
    /// The product of a combination and a direction is to be a value.
    void require(std::size_t first, const CurveWeights& weights, const Point& direction, double value);

    [[nodiscard]] std::vector<Point> solve() const;

private:
    struct Condition {
        std::size_t first;
        Eigen::Matrix<double, 12, 1> coefficients;
        double value;
    };

    std::size_t points_;
    std::vector<Eigen::Matrix3d> blocks_; ///< that couple a point with itself and the next three
    Eigen::VectorXd right_;               ///< coordinate c of control point k is unknown 3 k + c
    std::vector<Condition> conditions_;
};

} // namespace qm
