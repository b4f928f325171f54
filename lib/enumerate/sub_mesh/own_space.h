/// \file The search space of a single sub-mesh, when nothing outside it is known.
#pragma once

#include "enumerate/sub_mesh/search_space.h"

namespace qm {

/// The lines on which particles of a sub-mesh start, as a search space of their own. Lines, arcs and
/// junctions keep their order. As long as no arc of another line is present, `subMeshProblem` gives the same
/// problem for both spaces, except for the ids of arcs. Time is linear in the result; no line is in more than
/// two results.
[[nodiscard]] SearchSpace ownSpace(const SearchSpace& space, SubMeshId subMesh);

} // namespace qm
