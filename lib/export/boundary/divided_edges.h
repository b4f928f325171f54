/// \file Edges in two parts; the two that find edges to divide are defined in loose_edges.cpp and
/// twisted_edges.cpp.
#pragma once

#include "export/boundary/boundary.h"

#include <optional>
#include <vector>

namespace qm {

/// Divides edges at new vertices, in all outlines that they are part of.
/// \param at  by edge: the parameter where it is divided, if it is
/// \return whether there was one
bool divideEdges(Boundary& boundary, const std::vector<std::optional<double>>& at);

/// Divides edges that are farther than the resolution from a face's surface where they are farthest away.
/// Files hold no tolerances: whoever reads one measures an edge's distance from its faces at the ends and at
/// some points between, and trusts the largest. If the true one is only slightly larger, cuts through the
/// edge fail. At an end it is not missed. An edge stays whole if one part would be hardly longer than the
/// distance.
/// \return whether there was one
bool divideLooseEdges(Boundary& boundary);

/// Divides edges that bend, in the middle, if the normal of a spline face turns along them by 60 degrees
/// farther than they do; the parts again, if it still does. Who makes triangles takes as many points of an
/// edge as its own bends need, and then adds points within the face, because of its normals; where the face
/// twists, these come to lie beyond the chord between the edge's points, and triangles cross.
/// \return whether there was one
bool divideTwistedEdges(Boundary& boundary);

} // namespace qm
