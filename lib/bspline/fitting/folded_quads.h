/// \file Quads over which the reference folds although the mesh does not (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/fitting/fit_lattice.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

/// The faces that are flat and convex, and around which no face is folded: surfaces over them can be upright,
/// even where interpolation winds the reference. By face.
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

/// Where the reference folds over a sound quad its normals become those of the quad, to keep patches upright,
/// and its points are marked as guesses.
/// \param lattice  has the reference's points, normals and Jacobians, and room for marks
void unfoldQuads(const LatticeSource& source, FitLattice& lattice);

} // namespace qm
