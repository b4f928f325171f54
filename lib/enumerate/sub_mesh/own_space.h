/// \file What a search of one sub-mesh looks at when nothing outside is known.
#pragma once

#include "enumerate/sub_mesh/search_space.h"

namespace qm {

/// The lines on which particles of a sub-mesh start, as a search space of their own: lines, arcs and
/// junctions keep their order, and other lines are gone. As long as no arc of those is present,
/// `subMeshProblem` is the same in both, but for the ids of arcs. Takes time linear in the result; no line is
/// in more than two.
[[nodiscard]] SearchSpace ownSpace(const SearchSpace& space, SubMeshId subMesh);

} // namespace qm
