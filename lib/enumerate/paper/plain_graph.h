/// \file The plain motorcycle graph of Eppstein et al. (docs/METHOD.md#eppstein-2008) as it is defined in
/// docs/METHOD.md#plain-graph, the baseline to compare with.
#pragma once

#include "basecomplex/base_complex.h"
#include "layout/motorcycle_graph.h"

#include <vector>

namespace qm {

/// All particles advance one edge per step, and stop where somebody has been before. Of two that meet at a
/// right angle at the same time, the one on the clockwise side of the angle between the edges they came by
/// stops; of two that meet head-on, both. When more than two meet, all stop: what is left of the two lines
/// there is a T or a +.
///
/// Two that enter one edge from both ends at the same time meet at the far end of it as seen from the lower
/// separatrix. Tracks end where lines cross, so of two that met head-on elsewhere the lower separatrix's goes
/// on to the next crossing or to the end of its line, which leaves the graph as it is. Linear in the mesh but
/// for sorting the particles that are under way.
/// \return a motorcycle graph, tracks in the order of the separatrices
[[nodiscard]] MotorcycleGraph plainMotorcycleGraph(const QuadMesh& mesh, const BaseComplex& complex,
                                                   const std::vector<double>& edgeCosts);

} // namespace qm
