/// \file From the arcs of a graph to the tracks of particles (docs/METHOD.md#cracks).
#pragma once

#include "basecomplex/arc_graph.h"
#include "layout/motorcycle_graph.h"
#include "layout/walkers.h"

#include <span>
#include <vector>

namespace qm {

/// A mesh and the arcs of its base complex.
struct MeshArcs {
    const QuadMesh& mesh;
    const BaseComplex& complex;
    const ArcGraph& graph;
};

/// A track along a path, with its cost.
[[nodiscard]] Track trackOf(const QuadMesh& mesh, std::span<const HalfedgeId> path,
                            const std::vector<double>& edgeCosts);

/// The tracks of a graph with their costs, by line; particles that do not move have none.
[[nodiscard]] MotorcycleGraph graphOf(const MeshArcs& arcs, const PresentArcs& present,
                                      const std::vector<double>& edgeCosts, const Walkers& walkers = {});

/// The same for T-meshes, where only rules 1 and 2 hold: every run of arcs on a line is a track, and begins
/// at a source if it touches one.
[[nodiscard]] MotorcycleGraph tMeshOf(const MeshArcs& arcs, const PresentArcs& present,
                                      const std::vector<double>& edgeCosts);

/// The arcs that tracks cover, ascending. An arc may be covered by two tracks that meet head-on inside it.
/// \param arcOfEdge  the arc of every edge
/// \throw Error  if an edge of a track lies on no arc that is covered entirely
[[nodiscard]] std::vector<ArcId> coveredArcs(const QuadMesh& mesh, const ArcGraph& graph,
                                             const std::vector<ArcId>& arcOfEdge,
                                             const std::vector<Track>& tracks);

/// The same, as whether each arc is covered.
/// \throw Error  likewise
[[nodiscard]] PresentArcs presentArcs(const MeshArcs& arcs, const std::vector<Track>& tracks);

} // namespace qm
