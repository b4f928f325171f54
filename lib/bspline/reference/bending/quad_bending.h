/// \file The bending energy of a quad's surface as a function of the tilts of the tangent planes at its
/// corners (docs/METHOD.md#reference).
#pragma once

#include "bspline/reference/lattice/lagrange.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// The parameters of a quad's corners, counter-clockwise.
constexpr std::array<std::array<std::size_t, 2>, 4> quadCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// A tangent plane and two axes in it. It may be tilted by slopes along these, upwards positive, and at a
/// regular vertex the surface may be twisted, which lifts it by the product of the steps along both mesh
/// lines.
struct TangentFrame {
    Eigen::Vector3d normal;
    std::array<Eigen::Vector3d, 2> axes;
    /// The dual basis of the mesh lines: its products with a vector are the vector's steps along them; zero
    /// where there is no twist.
    std::array<Eigen::Vector3d, 2> dual;
    /// How much a tilt twists each quad here, as a multiple of the sum of its slopes along the quad's two
    /// edges.
    double twistOfSlopes = 0;
};

/// The twist by which tilted quads around an extraordinary vertex stay tangent to one another, to second
/// order in the distance from it; 0 at a regular one.
[[nodiscard]] double twistOfSlopes(int valence);

/// The frames at a quad's corners, in the order of `quadCorners`; null where the tangent plane is fixed.
using CornerFrames = std::array<const TangentFrame*, 4>;

/// The slopes along the axes of corner c's frame are entries 3 c and 3 c + 1, its twist is entry 3 c + 2.
using CornerTilts = Eigen::Matrix<double, 12, 1>;

/// The polynomial through (steps + 1)^2 lattice points, row by row, over the unit square.
class QuadSurface {
public:
    QuadSurface(int steps, std::vector<Eigen::Vector3d> points);

    [[nodiscard]] int steps() const { return steps_; }
    /// Derivative by u (0) or v (1) at a corner.
    [[nodiscard]] const Eigen::Vector3d& derivative(std::size_t corner, std::size_t direction) const {
        return derivatives_[corner][direction];
    }
    /// Of unit length, or zero if the surface has none.
    [[nodiscard]] Eigen::Vector3d normal(std::size_t corner) const;

    /// First and second partial derivatives.
    struct SecondOrder {
        Eigen::Vector3d u, v, uu, uv, vv;
    };
    /// \param columns, rows  the weights of the lattice's columns at u, and of its rows at v
    [[nodiscard]] SecondOrder secondOrder(const LagrangeWeights& columns, const LagrangeWeights& rows) const;

    /// The displacement of every lattice point, along its own normal, when the corners are tilted and
    /// twisted: cubics that vanish at the corners.
    [[nodiscard]] std::vector<Eigen::Vector3d> displacements(const CornerFrames& frames,
                                                             const CornerTilts& tilts) const;

private:
    int steps_;
    std::vector<Eigen::Vector3d> points_;
    std::array<std::array<Eigen::Vector3d, 2>, 4> derivatives_; ///< by corner and direction
};

/// The integral of the squared principal curvatures up to a constant, x' matrix x / 2 - right' x for tilts x.
/// Rows of fixed corners are zero.
struct QuadBending {
    Eigen::Matrix<double, 12, 12> matrix;
    CornerTilts right;
};

/// Linearises the bending, with three Gauss points in each direction; points without a normal are left out.
[[nodiscard]] QuadBending quadBending(const QuadSurface& surface, const CornerFrames& frames);

} // namespace qm
