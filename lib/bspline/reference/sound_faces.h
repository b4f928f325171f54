/// \file Quads over which surfaces need not fold, even where interpolation makes the reference fold.
#pragma once

#include "bspline/splines/evaluate.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

/// Cosine of the angle between the normals in the middle and at a corner of a nearly flat quad: 20 degrees.
constexpr double nearlyFlat = 0.94;

/// By face: whether it is flat within an angle, nearly if not told otherwise, and convex, and no face around
/// it is folded. Surfaces can be upright over such faces even where interpolation makes the reference fold.
/// \param minCosine  of the angle between the normals in the middle and at any corner
[[nodiscard]] std::vector<bool> soundFaces(const QuadMesh& mesh, double minCosine = nearlyFlat);

/// By vertex: whether all faces around it are sound.
[[nodiscard]] std::vector<bool> soundVertices(const QuadMesh& mesh, double minCosine = nearlyFlat);

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

/// A surface counts as folded over a sound quad if the cosine of the angle between their normals is less: 80
/// degrees.
constexpr double uprightCosine = 0.17;

} // namespace qm
