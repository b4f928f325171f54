/// \file Polynomial pieces of tensor-product surfaces in Bernstein's form, whose points bound what lies
/// between (Farin, Curves and Surfaces for CAGD).
#pragma once

#include "base/at.h"
#include "bspline/splines/bezier_extraction.h"
#include "bspline/splines/surfaces.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace qm {

/// A polynomial over [0, 1] x [0, 1]: point (i, j), i along u, is points[j * (degree[0] + 1) + i].
struct BezierPiece {
    std::array<int, 2> degree{};
    std::vector<Eigen::Vector3d> points;

    [[nodiscard]] const Eigen::Vector3d& at(int i, int j) const {
        return points[qm::at(j) * (qm::at(degree[0]) + 1) + qm::at(i)];
    }
};

/// Calls a function with column, row and position of every Bezier point, row by row.
template <class Function> void forEachPoint(const BezierPiece& piece, const Function& function) {
    auto point = piece.points.begin();
    for (int j = 0; j <= piece.degree[1]; ++j)
        for (int i = 0; i <= piece.degree[0]; ++i)
            function(i, j, *point++);
}

/// A lattice of control points with the extractions along u and along v. What is passed must outlive it.
struct BezierPieces {
    std::array<BezierExtraction, 2> along;
    std::span<const Point> controls; ///< row by row
    std::size_t width = 0;           ///< of a row

    /// The piece over interval i of u and j of v.
    /// \param piece  written over; keeps its memory
    void get(std::size_t i, std::size_t j, BezierPiece& piece) const;
};

/// The pieces between the knots of a patch, which must outlive them.
[[nodiscard]] BezierPieces bezierPieces(const Patch& patch);
/// The same cut at further parameters as well, and elevated to higher degrees.
[[nodiscard]] BezierPieces bezierPieces(const Patch& patch, const std::array<std::vector<double>, 2>& breaks,
                                        const std::array<int, 2>& elevatedTo);

/// The knots of a patch and the lines of its segment's grid as parameters at which to cut, along u and along
/// v, ascending; what is nearer than 1e-9 to its neighbour counts once.
[[nodiscard]] std::array<std::vector<double>, 2> knotsAndGridLines(const Patch& patch);

/// A piece of a patch, and the parameters over which it lies.
struct PatchPiece {
    BezierPiece piece;
    ParameterBox box{};
};

/// Calls a function with every `PatchPiece`, row by row.
template <class Function> void forEachPiece(const BezierPieces& pieces, const Function& function) {
    const auto& [u, v] = pieces.along;
    for (std::size_t j = 0; j < v.intervals(); ++j)
        for (std::size_t i = 0; i < u.intervals(); ++i) {
            PatchPiece part{{}, {u.range(i), v.range(j)}};
            pieces.get(i, j, part.piece);
            function(std::move(part));
        }
}

/// The pieces over the quarters of a piece's box.
[[nodiscard]] std::array<PatchPiece, 4> quarters(const PatchPiece& whole);

/// The piece over a box within (0, 0) to (1, 1).
/// \param result  another piece; keeps its memory
void restrict(const BezierPiece& piece, const std::array<double, 2>& from, const std::array<double, 2>& to,
              BezierPiece& result);

/// The largest distance of a piece's Bezier points from a place, which no point of the piece exceeds.
[[nodiscard]] double farthestFrom(const Eigen::Vector3d& place, const BezierPiece& piece);

/// Point and derivatives by the parameters of the unit square.
struct PiecePoint {
    Eigen::Vector3d position;
    Eigen::Vector3d du;
    Eigen::Vector3d dv;
};
[[nodiscard]] PiecePoint evaluate(const BezierPiece& piece, double u, double v);

/// By u: direction 0, by v: direction 1. Of one degree less in that direction, which must be at least 1.
[[nodiscard]] BezierPiece derivative(const BezierPiece& piece, std::size_t direction);

/// du x dv, of degrees 2 degree[0] - 1 and 2 degree[1] - 1; degrees must be at least 1.
[[nodiscard]] BezierPiece normalPiece(const BezierPiece& piece);

} // namespace qm
