/// \file Searching the whole mesh after its sub-meshes, so that no graph suffers from where the cut runs
/// (docs/METHOD.md#merging).
#pragma once

#include "base/control.h"
#include "enumerate/sub_mesh/search_space.h"
#include "enumerate/window/window_search.h"

#include <optional>

namespace qm {

struct WholeSearch {
    PresentArcs present;             ///< the arcs of a graph that is at most as expensive as the start
    double lowerBound = 0;           ///< no graph is cheaper
    bool proven = false;             ///< whether the graph is the cheapest
    IdVector<ArcId, double> relaxed; ///< value of every arc in the relaxed solution; empty if there is none
};

/// Searches the whole mesh at once. Most models are proven within a second, sooner than windows could improve
/// the merged graph. Where independent parts are large, only the roots are searched, and nothing where they
/// are very large. The limits count variables and nodes, so the result does not depend on the machine.
/// \param present  the arcs of a valid graph of the whole mesh
/// \return nothing if so many lines depend on each other that the search would take too long
[[nodiscard]] std::optional<WholeSearch> searchWhole(const SearchSpace& space, const PresentArcs& present,
                                                     const Control& control = {});

/// Searches windows that are no harder than a sub-mesh, wherever the cut runs, up to a limit of their number.
/// \param present     the arcs of a valid graph of the whole mesh
/// \param complexity  chi of the sub-meshes
/// \param relaxed     value of every arc in the relaxed solution; empty if unknown
[[nodiscard]] WindowResult moveCuts(const SearchSpace& space, const PresentArcs& present, double complexity,
                                    IdVector<ArcId, double> relaxed, const Control& control = {});

} // namespace qm
