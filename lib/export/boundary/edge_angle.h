/// \file The normals of the two faces of an edge, and the angle between them.
#pragma once

#include "export/boundary/boundary.h"

#include <array>
#include <gp_Dir.hxx>
#include <optional>

namespace qm {

/// The outward normal of the face on a side of an edge, at a parameter of the edge; none where it has no
/// normal.
[[nodiscard]] std::optional<gp_Dir> normalAt(const BoundaryFace& face, const BoundaryEdge& edge,
                                             std::size_t side, double parameter);

/// The largest angle between the outward normals of both faces along an edge, in degrees, by samples; where a
/// face has no normal, it does not count.
/// \param faces     by side
/// \param fromEnds  how far samples are from the ends, where a face may have no normal, in shares of the edge
[[nodiscard]] double largestAngle(const BoundaryEdge& edge, const std::array<const BoundaryFace*, 2>& faces,
                                  double fromEnds);

} // namespace qm
