/// \file The paper's three algorithms (docs/METHOD.md#gunpinar-2016), on coordinates of particles
/// (docs/METHOD.md#coordinate-search).
///
/// They visit a graph once for every set of particle positions that produces it and are kept for comparison;
/// the searches on arcs visit each graph once.
#pragma once

#include "enumerate/state/assignment.h"

#include <functional>

namespace qm {

enum class CoordinateMethod {
    naive,   ///< all coordinate vectors, filtered by A1 to A4
    bounds,  ///< bounds B1 to B4 on undo stacks
    improved ///< B4' instead of B4: drops head-on meetings that nothing passes
};

/// Calls `visit` with the arcs of every coordinate vector found; it ends the search by returning false.
/// \param problem        a whole mesh or the particles of one sub-mesh
/// \param stopRequested  asked now and then, as most steps lead to no graph; ends the search too
/// \return false if the search was ended
bool forEachCoordinateVector(
    const Problem& problem, CoordinateMethod method, const std::function<bool(const Assignment&)>& visit,
    const std::function<bool()>& stopRequested = [] { return false; });

} // namespace qm
