/// \file The paper's three algorithms (docs/METHOD.md#gunpinar-2016), which search over the coordinates of
/// particles (docs/METHOD.md#coordinate-search).
///
/// They visit a graph once for every vector of coordinates that produces it, and are kept for comparison
/// only; the searches over arcs visit each graph once.
#pragma once

#include "enumerate/state/assignment.h"

#include <functional>

namespace qm {

enum class CoordinateMethod {
    naive,   ///< all coordinate vectors, filtered by A1 to A4
    bounds,  ///< bounds B1 to B4 on undo stacks
    improved ///< B4' instead of B4: leaves out head-on meetings that no particle passes
};

/// Calls `visit` with the graph of every coordinate vector found, until `visit` returns false.
/// \param problem        a whole mesh or the particles of one sub-mesh
/// \param stopRequested  asked regularly, because most steps lead to no graph; also ends the search
/// \return false if the search was ended
/// \throw Error  if there are thousands of particles
bool forEachCoordinateVector(
    const Problem& problem, CoordinateMethod method, const std::function<bool(const Assignment&)>& visit,
    const std::function<bool()>& stopRequested = [] { return false; });

} // namespace qm
