/// \file The smallest change of control points that moves some of them into planes.
#pragma once

#include "bspline/fitting/planes/plane_demands.h"
#include "bspline/solver/constrained_system.h"
#include "bspline/solver/linear_form.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Two control points of a patch, next to one another.
using NeighbouringPoints = std::array<std::size_t, 2>;

/// Finds the change by one sparse system in which every coordinate is an unknown of its own, since planes mix
/// them. The equations hold for the points before it and after it.
class MinChange {
public:
    /// \param points      number of control points that may move
    /// \param neighbours  what is moved takes its neighbours along
    MinChange(std::size_t points, std::vector<LinearForm> equations,
              std::vector<NeighbouringPoints> neighbours = {});

    /// Planes that contradict one another, given the equations, are missed by as little as possible; all
    /// others are met up to rounding.
    /// \param points  one row per control point that may move
    [[nodiscard]] Eigen::MatrixX3d run(const std::vector<PlaneDemand>& demands,
                                       const Eigen::MatrixX3d& points) const;

    /// The largest violation of an equation by a change.
    [[nodiscard]] double violation(const Eigen::MatrixX3d& change) const;

private:
    [[nodiscard]] Eigen::MatrixX3d allowed(const Eigen::MatrixX3d& change) const;

    std::size_t points_;
    std::vector<LinearForm> equations_;
    std::vector<NeighbouringPoints> neighbours_;
    ConstrainedSystem allowed_;
};

/// By demand: how far the point is below its plane.
[[nodiscard]] Eigen::VectorXd missingHeights(const std::vector<PlaneDemand>& demands,
                                             const Eigen::MatrixX3d& points);

} // namespace qm
