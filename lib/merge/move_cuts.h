/// \file Searching across the cut, so that no graph suffers from where it runs (docs/METHOD.md#merging).
#pragma once

#include "base/control.h"
#include "enumerate/sub_mesh/search_space.h"
#include "enumerate/window/window_search.h"

namespace qm {

/// Searches windows that are no harder than a sub-mesh, wherever the cut runs, up to a limit of their number.
/// \param present     the arcs of a valid graph of the whole mesh
/// \param complexity  chi of the sub-meshes
/// \param relaxed     value of every arc in the relaxed solution; empty if unknown
[[nodiscard]] WindowResult moveCuts(const SearchSpace& space, const PresentArcs& present, double complexity,
                                    IdVector<ArcId, double> relaxed, const Control& control = {});

} // namespace qm
