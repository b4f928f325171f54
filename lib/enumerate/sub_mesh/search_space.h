/// \file The data that all searches on one model share, and the problem of a single sub-mesh
/// (docs/METHOD.md#sub-meshes).
#pragma once

#include "enumerate/sub_mesh/extend.h"
#include "layout/constraints.h"
#include "mesh/sub_meshes.h"

#include <unordered_map>
#include <vector>

namespace qm {

struct SearchSpace {
    ArcGraph graph;
    IdVector<ArcId, double> arcCosts;
    IdVector<ArcId, ArcState> demands;    ///< constraint on every arc; empty without constraints
    IdVector<ArcId, SubMeshId> arcBegins; ///< sub-mesh of the vertex where each arc begins on its line
    IdVector<ArcId, SubMeshId> arcEnds;   ///< likewise where each arc ends
    IdVector<JunctionId, SubMeshId> junctionLabels;
    /// The lines with a source in each sub-mesh, ascending; no entry for sub-meshes without sources.
    std::unordered_map<SubMeshId, std::vector<LineId>> linesOf;
    double cornerCost = 0; ///< of every corner of a segment
};

/// The costs that make up that of a graph.
struct PlaceCosts {
    const std::vector<double>& ofEdges;
    double ofCorner = 0; ///< of every corner of a segment
};

/// \throw Error  if a constraint names an edge on no separatrix, or forbids an edge of the mesh boundary
[[nodiscard]] SearchSpace makeSearchSpace(const QuadMesh& mesh, const BaseComplex& complex,
                                          const PlaceCosts& costs, const SubMeshes& subMeshes,
                                          const Constraints& constraints);

/// The lines on which particles of a sub-mesh start, as a search space of their own, for searches to which
/// nothing outside is known (own_space.cpp). Lines, arcs and junctions keep their order. As long as no arc of
/// another line is present, `subMeshProblem` gives the same problem for both spaces, except for the ids of
/// arcs. Time is linear in the result; no line is in more than two results.
[[nodiscard]] SearchSpace ownSpace(const SearchSpace& space, SubMeshId subMesh);

/// A search of the whole mesh: all arcs are free.
/// \param space  must outlive the result
[[nodiscard]] ProblemInput wholeInput(const SearchSpace& space);

/// The cost of a graph: of its arcs, and of the corners at junctions.
[[nodiscard]] double costOf(const SearchSpace& space, const PresentArcs& present);

/// The arcs that a particle can walk in a sub-mesh, up to and including the one that leaves it.
/// \param from  how many arcs it has walked before, from its source on
[[nodiscard]] std::vector<ArcId> walkInside(const SearchSpace& space, Particle particle, SubMeshId subMesh,
                                            int from = 0);

/// The lines with a source in a sub-mesh.
[[nodiscard]] const std::vector<LineId>& linesFrom(const SearchSpace& space, SubMeshId subMesh);

/// The arcs that the particles of a sub-mesh can walk before they leave it.
[[nodiscard]] std::vector<ArcId> ownArcs(const SearchSpace& space, SubMeshId subMesh);

/// The particles that start in a sub-mesh, and those of the lines in `others` that have walked already.
[[nodiscard]] Walkers walkersOf(const SearchSpace& space, SubMeshId subMesh, const PresentArcs& present,
                                const std::vector<LineId>& others = {});

/// The problem of one sub-mesh: the given arcs are free, and all others are fixed as in `present`. Tracks may
/// end unfinished at the first vertex outside. Time is linear in what `makeProblem` visits.
[[nodiscard]] Problem subMeshProblem(const SearchSpace& space, SubMeshId subMesh,
                                     const std::vector<ArcId>& freeArcs, const PresentArcs& present);

/// Makes a graph without a search: every particle of the sub-mesh in turn goes straight on to the first track
/// or to the first vertex outside. The result is always valid.
void goStraight(const SearchSpace& space, SubMeshId subMesh, PresentArcs& present);

} // namespace qm
