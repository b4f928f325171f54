/// \file Directions in which border curves leave corners at which the mesh's edges lie too close together.
#pragma once

#include "bspline/chains.h"
#include "bspline/line_derivatives.h"

#include <vector>

namespace qm {

/// Where two borders leave a vertex at a small angle, or in the wrong order, every patch between them would
/// be folded. There the borders' directions in the tangent plane are spread as little as needed.
class CornerDirections {
public:
    CornerDirections(const QuadMesh& mesh, const Chains& chains, const LineDerivatives& lines);

    /// Unit vector in which the curve should leave the vertex that `halfedge` leaves; zero if the mesh's own
    /// direction is good enough.
    [[nodiscard]] Point operator[](HalfedgeId halfedge) const;

private:
    void spread(const QuadMesh& mesh, const std::vector<HalfedgeId>& around, const Point& normal);

    std::vector<Point> directions_; ///< by halfedge
};

} // namespace qm
