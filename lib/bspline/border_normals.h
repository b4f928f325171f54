/// \file Normals that a patch should have on its border, and how far its own are from them.
#pragma once

#include "bspline/evaluate.h"
#include "bspline/spline_curve.h"
#include "bspline/surfaces.h"

#include <array>
#include <vector>

namespace qm {

/// Curves on a patch's border, or something at the places of `normalParameters` on them: along u and along v,
/// each at the lower and at the upper end of the other parameter.
template <class T> using OnBorder = std::array<std::array<T, 2>, 2>;

/// From make(side, turned) for every side, counter-clockwise from side 0; `turned` if the side runs against
/// the parameter.
template <class T, class Make> [[nodiscard]] OnBorder<T> onBorder(const Make& make) {
    return {{{make(0, false), make(2, true)}, {make(3, true), make(1, false)}}};
}

/// Shares of an edge at which normals are prescribed.
constexpr std::array<double, 5> normalShares = {0.03, 0.25, 0.5, 0.75, 0.97};

/// Where a patch's normals on a border of so many edges are prescribed.
[[nodiscard]] std::vector<double> normalParameters(int edges);

/// A patch at `normalParameters` on one border: along u (0) or v (1), at the lower or the upper end of the
/// other parameter.
[[nodiscard]] std::vector<SurfacePoint> pointsOnBorder(const Patch& patch, std::size_t direction,
                                                       std::size_t end);
/// The unit normals there.
[[nodiscard]] std::vector<Point> normalsOnBorder(const Patch& patch, std::size_t direction, std::size_t end);

/// The normal's part orthogonal to the tangent, of length one; zero where they are far from orthogonal.
[[nodiscard]] Point unitNormalAcross(const Point& normal, const Point& tangent);

/// Angles, in degrees, between a patch's normals and the prescribed ones; 0 where none is prescribed.
[[nodiscard]] OnBorder<std::vector<double>> anglesOff(const OnBorder<std::vector<Point>>& normals,
                                                      const OnBorder<SplineCurve>& border,
                                                      const Patch& patch);

} // namespace qm
