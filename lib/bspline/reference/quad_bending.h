/// \file How much a quad's surface bends in space when tangent planes at its corners are tilted
/// (docs/METHOD.md#reference).
#pragma once

#include "bspline/reference/lagrange.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// A tangent plane, and the directions that tilts are told in: the slopes along them, upwards positive.
struct TangentFrame {
    Eigen::Vector3d normal;
    std::array<Eigen::Vector3d, 2> axes;
};

/// The frames at a quad's corners, counter-clockwise from (0, 0); null where the tangent plane is fixed.
using CornerFrames = std::array<const TangentFrame*, 4>;

/// Slopes along the axes of corner c's frame at 2 c and 2 c + 1.
using CornerTilts = Eigen::Matrix<double, 8, 1>;

/// The polynomial through (steps + 1)^2 lattice points, row by row, over the unit square.
class QuadSurface {
public:
    QuadSurface(int steps, std::vector<Eigen::Vector3d> points);

    [[nodiscard]] int steps() const { return steps_; }
    /// Derivative by u (0) or v (1) at a corner.
    [[nodiscard]] const Eigen::Vector3d& derivative(std::size_t corner, std::size_t direction) const {
        return derivatives_[corner][direction];
    }
    /// Of unit length, or zero.
    [[nodiscard]] Eigen::Vector3d normal(std::size_t corner) const;

    struct SecondOrder {
        Eigen::Vector3d u, v, uu, uv, vv;
    };
    [[nodiscard]] SecondOrder secondOrder(double u, double v) const;

    /// Every lattice point's way when corners are tilted, each along its own normal: cubics whose values at
    /// the corners are zero.
    [[nodiscard]] std::vector<Eigen::Vector3d> displacements(const CornerFrames& frames,
                                                             const CornerTilts& tilts) const;

private:
    int steps_;
    std::vector<Eigen::Vector3d> points_;
    std::array<std::array<Eigen::Vector3d, 2>, 4> derivatives_; ///< by corner and direction
};

/// The integral of the squared principal curvatures, but for a constant: x' matrix x / 2 - right' x, for
/// tilts x. Rows of fixed corners are zero.
struct QuadBending {
    Eigen::Matrix<double, 8, 8> matrix;
    CornerTilts right;
};

/// Linearised, by two Gauss points each way; those where the surface has no normal do not count.
[[nodiscard]] QuadBending quadBending(const QuadSurface& surface, const CornerFrames& frames);

} // namespace qm
