/// \file The least change of control points that puts some of them into planes.
#pragma once

#include "bspline/fitting/constrained_system.h"
#include "bspline/fitting/plane_patches.h"
#include "bspline/network/border_strip.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace qm {

/// A control point that is to lie in a plane.
struct PlaneDemand {
    std::size_t unknown = 0;
    Plane plane;
};

/// Under equations that hold already: found by conjugate gradients for the distances from the planes, in the
/// space of what the equations allow.
class LeastChange {
public:
    /// \param unknowns  control points that may move
    LeastChange(std::size_t unknowns, std::vector<LinearForm> equations);

    /// \param points  a row for every control point that may move
    [[nodiscard]] Eigen::MatrixX3d run(const std::vector<PlaneDemand>& demands,
                                       Eigen::MatrixX3d points) const;

    /// By how much a change violates the equations, at most.
    [[nodiscard]] double violation(const Eigen::MatrixX3d& change) const;

private:
    [[nodiscard]] Eigen::MatrixX3d change(const std::vector<PlaneDemand>& demands,
                                          const Eigen::MatrixX3d& points) const;
    [[nodiscard]] Eigen::MatrixX3d allowed(const Eigen::MatrixX3d& change, Accuracy accuracy) const;

    Eigen::Index unknowns_;
    std::vector<LinearForm> equations_;
    ConstrainedSystem allowed_;
};

/// By demand, how far the point is below its plane.
[[nodiscard]] Eigen::VectorXd missingHeights(const std::vector<PlaneDemand>& demands,
                                             const Eigen::MatrixX3d& points);

/// The largest distance of a point from the origin: what rounding is measured by.
[[nodiscard]] double largestDistance(const Eigen::MatrixX3d& points);

} // namespace qm
