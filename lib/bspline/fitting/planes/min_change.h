/// \file The smallest change of control points that moves some of them into planes.
#pragma once

#include "bspline/fitting/planes/plane_demands.h"
#include "bspline/fitting/planes/tied_points.h"
#include "bspline/network/border_strip.h"
#include "bspline/solver/constrained_system.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace qm {

/// Finds the change by one sparse system in which every coordinate is an unknown of its own, since planes mix
/// them. The equations hold for the points before it and after it.
class MinChange {
public:
    /// \param unknowns  number of control points that may move
    MinChange(std::size_t unknowns, std::vector<LinearForm> equations);

    /// Planes that contradict one another, given the equations, are missed by as little as possible; all
    /// others are met up to rounding.
    /// \param points  one row per control point that may move
    [[nodiscard]] Eigen::MatrixX3d run(const std::vector<PlaneDemand>& demands,
                                       const Eigen::MatrixX3d& points) const;

    /// The largest violation of an equation by a change.
    [[nodiscard]] double violation(const Eigen::MatrixX3d& change) const;

private:
    [[nodiscard]] Eigen::MatrixX3d allowed(Eigen::MatrixX3d change) const;

    std::vector<LinearForm> equations_;
    TiedPoints tied_; ///< most points on borders are tied to others: fewer unknowns
    ConstrainedSystem allowed_;
};

/// By demand: how far the point is below its plane.
[[nodiscard]] Eigen::VectorXd missingHeights(const std::vector<PlaneDemand>& demands,
                                             const Eigen::MatrixX3d& points);

/// The largest distance of a point from the origin, relative to which rounding errors are measured.
[[nodiscard]] double largestDistance(const Eigen::MatrixX3d& points);

} // namespace qm
