/// \file Quads over which surfaces can be upright, even where interpolation winds them.
#pragma once

#include "bspline/splines/evaluate.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

/// The faces that are nearly flat and convex, and around which no face is folded: surfaces over them can be
/// upright, even where interpolation winds the reference. By face.
[[nodiscard]] std::vector<bool> soundFaces(const QuadMesh& mesh);

/// The bilinear surface through four points, counter-clockwise from the lowest parameters.
class BilinearQuad {
public:
    explicit BilinearQuad(const std::array<Point, 4>& corners);

    /// With its derivatives, 0 to 1 in both directions.
    [[nodiscard]] SurfacePoint evaluate(double s, double t) const;
    [[nodiscard]] const Point& normal() const { return normal_; }
    /// Cosine of the angle between the normal in the middle and that at a corner, the least.
    [[nodiscard]] double minCosine() const;

private:
    std::array<Point, 4> corners_;
    Point normal_; ///< unit, in the middle
};

/// Cosine between the normal of a sound quad and a surface over it, above which this is not folded: of 80
/// degrees.
constexpr double uprightCosine = 0.17;

} // namespace qm
