/// \file Curves above edges, determined by the two ends alone (docs/METHOD.md#reference).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "bspline/reference/planes/plane_corners.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

/// Cubics between the ends of edges, as straight as the tangent planes or crease directions at the ends
/// allow. The derivatives there are as long as the edge, so that no curve overshoots, however uneven the
/// edges around it are.
class EdgeCurves {
public:
    /// The arguments must outlive the curves.
    /// \param corners  whose planes the derivatives have to lie in; null if there are none
    EdgeCurves(const QuadMesh& mesh, const Sharpness& sharpness, const PlaneCorners* corners)
        : mesh_(mesh), sharpness_(sharpness), corners_(corners) {}

    /// The Bezier points above a halfedge, from its beginning to its end.
    [[nodiscard]] std::array<Point, 4> above(HalfedgeId halfedge) const;

private:
    [[nodiscard]] Point derivative(HalfedgeId leaving) const;
    [[nodiscard]] Point alongSurface(HalfedgeId leaving) const;
    [[nodiscard]] Point normalBeside(HalfedgeId leaving) const;
    [[nodiscard]] Point normalIn(HalfedgeId leaving) const;

    const QuadMesh& mesh_;
    Sharpness sharpness_;
    const PlaneCorners* corners_;
};

} // namespace qm
