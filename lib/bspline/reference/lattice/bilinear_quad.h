/// \file The bilinear surface through the corners of a quad.
#pragma once

#include "bspline/reference/lattice/reference_grid.h"
#include "bspline/splines/evaluate.h"

#include <array>

namespace qm {

/// The bilinear surface through four points, counter-clockwise from the lowest parameters.
class BilinearQuad {
public:
    explicit BilinearQuad(const std::array<Point, 4>& corners);

    /// Point and derivatives at parameters from 0 to 1.
    [[nodiscard]] SurfacePoint evaluate(double s, double t) const;
    [[nodiscard]] const Point& normal() const { return normal_; }
    /// The smallest cosine of the angle between the normal in the middle and that at a corner.
    [[nodiscard]] double minCosine() const;

private:
    std::array<Point, 4> corners_;
    Point normal_; ///< unit, in the middle
};

/// That of quad (i, j) of a grid, of which the reference interpolates the corners.
[[nodiscard]] BilinearQuad quadBelow(const ReferenceGrid& reference, int i, int j);

} // namespace qm
