/// \file The plain motorcycle graph of Eppstein et al. (docs/METHOD.md#eppstein-2008) as defined in
/// docs/METHOD.md#plain-graph, a baseline for comparison.
#pragma once

#include "basecomplex/base_complex.h"
#include "layout/motorcycle_graph.h"

#include <vector>

namespace qm {

/// All particles advance one edge per step, and stop at vertices that have been visited before. Of two
/// particles that meet at a right angle at the same time, the one on the clockwise side of the angle between
/// their last edges stops; two that meet head-on both stop. When more than two meet, all stop, which leaves a
/// T or a + of the two lines.
///
/// Two particles that enter one edge from both ends in the same step meet at its far end as seen from the
/// lower separatrix. Tracks end where lines cross, so after a head-on meeting elsewhere the track of the
/// lower separatrix is extended to the next crossing or to the end of its line, which leaves the graph as it
/// is. Time is linear in the mesh, apart from sorting the moving particles.
/// \return a motorcycle graph, its tracks in the order of their separatrices
[[nodiscard]] MotorcycleGraph plainMotorcycleGraph(const QuadMesh& mesh, const BaseComplex& complex,
                                                   const std::vector<double>& edgeCosts);

} // namespace qm
