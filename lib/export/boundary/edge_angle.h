/// \file The normals of the two faces of an edge, and the angle between them.
#pragma once

#include "export/geometry/curve_piece.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Surface.hxx>
#include <array>
#include <gp_Dir.hxx>
#include <optional>

namespace qm {

/// The face on one side of an edge.
struct EdgeSide {
    Handle(Geom_Surface) surface;
    bool reversed = false;              ///< the surface's normal points inwards
    Handle(Geom2d_BSplineCurve) onFace; ///< of the edge; none on a plane
};

/// The outward normal of the face at a parameter of the edge; none where it has no normal.
[[nodiscard]] std::optional<gp_Dir> normalAt(const EdgeSide& side, double parameter);

/// The largest angle between the outward normals of both faces along an edge, in degrees, by samples; where a
/// face has no normal, it does not count.
/// \param curve     has the parameters of both curves on the faces
/// \param fromEnds  how far samples are from the ends, where a face may have no normal, in shares of the edge
[[nodiscard]] double largestAngle(const CurvePiece& curve, const std::array<EdgeSide, 2>& sides,
                                  double fromEnds);

} // namespace qm
