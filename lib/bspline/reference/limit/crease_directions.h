/// \file Directions of creases and of the mesh boundary at vertices, by splines that know how long edges are
/// (docs/METHOD.md#reference).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// The direction in which a curve of creases passes each vertex: that of the cubic spline with continuous
/// second derivatives through the curve's vertices, whose parameters advance by the lengths of edges. Where
/// all edges are equally long it is the direction of a subdivision curve, except near its ends: curves end as
/// parabolas. Linear in the mesh.
/// \return by vertex: a unit vector into the first edge of the rule's `along`; zero if no curve passes, or if
///         one of both edges has no length
[[nodiscard]] std::vector<Point> creaseDirections(const QuadMesh& mesh, const std::vector<VertexRule>& rules);

} // namespace qm
