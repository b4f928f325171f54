/// \file From arcs to particles: who walked what (docs/METHOD.md#cracks).
#pragma once

#include "basecomplex/arc_graph.h"
#include "layout/motorcycle_graph.h"
#include "layout/walkers.h"

#include <vector>

namespace qm {

/// The tracks of a graph, by line, with their costs; particles that do not move have none.
[[nodiscard]] MotorcycleGraph graphOf(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
                                      const std::vector<bool>& present, const std::vector<double>& edgeCosts,
                                      const Walkers& walkers = {});

/// The same for rules 1 and 2 alone: every run of arcs on a line is a track, and begins at a source if it
/// touches one.
[[nodiscard]] MotorcycleGraph tMeshOf(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
                                      const std::vector<bool>& present, const std::vector<double>& edgeCosts);

/// The arcs that tracks cover together, ascending; two that meet head-on may do so inside an arc.
/// \param arcOfEdge  the arc of every edge
/// \throw Error  if an edge of a track is on no arc that is covered throughout
[[nodiscard]] std::vector<ArcId> coveredArcs(const QuadMesh& mesh, const ArcGraph& graph,
                                             const std::vector<ArcId>& arcOfEdge,
                                             const std::vector<Track>& tracks);

/// The same, of every arc whether it is covered.
/// \throw Error  likewise
[[nodiscard]] std::vector<bool> presentArcs(const QuadMesh& mesh, const BaseComplex& complex,
                                            const ArcGraph& graph, const std::vector<Track>& tracks);

} // namespace qm
