/// \file The base complex as arcs and junctions, the form on which the search works
/// (docs/METHOD.md#arc-rules).
#pragma once

#include "base/id_vector.h"
#include "base/ids.h"
#include "basecomplex/base_complex.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace qm {

/// A separatrix without direction; or, if its two particles can never meet because each is stopped by its own
/// track before, the reach of one of them. Its arcs are consecutive: firstArc to firstArc + arcCount - 1, in
/// the direction of `forward`.
struct Line {
    SeparatrixId forward;                 ///< the one of the two directions with the lower id
    std::optional<SeparatrixId> backward; ///< the opposite; none if only one particle runs on the line
    std::size_t length = 0;               ///< halfedges
    ArcId firstArc;
    int arcCount = 0;
    JunctionId beginsAt = {}; ///< if the line begins at a seed that another line crosses
    JunctionId endsAt = {};   ///< if it ends at such a seed, or at its own track

    [[nodiscard]] ArcId lastArc() const { return firstArc + (arcCount - 1); }
    [[nodiscard]] IdRange<ArcId> arcs() const { return {firstArc, firstArc + arcCount}; }
};

/// The part of a line between successive stops.
struct Arc {
    LineId line;
    int begin = 0; ///< half-open range of the halfedges of the line's forward separatrix
    int end = 0;
};

/// A place between the ends of a line where a particle may stop: a regular vertex where two lines cross, or,
/// if the mesh is cut, a vertex beside the cut. `arcs[0]` and `arcs[2]` are opposite each other, and so are
/// `arcs[1]` and `arcs[3]`. If no line crosses, the latter two are invalid; if a line ends at its own track,
/// only arcs[3] is.
struct Junction {
    VertexId vertex;
    std::array<ArcId, 4> arcs;
    /// Whether this is a feature seed: arcs[0] and arcs[2] start here, are in every graph, and never meet
    /// head-on here.
    bool seeded = false;

    [[nodiscard]] bool crossed() const { return arcs[1].valid(); }
    /// Whether arcs[k] and arcs[k + 2], k being 0 or 1, start here.
    [[nodiscard]] bool isSeedOf(std::size_t k) const { return seeded && k == 0; }
    /// The arcs of the other line than that of an arc here.
    [[nodiscard]] std::array<ArcId, 2> across(ArcId arc) const {
        const std::size_t other = arcs[0] == arc || arcs[2] == arc ? 1 : 0;
        return {arcs[other], arcs[other + 2]};
    }
};

struct ArcGraph {
    IdVector<LineId, Line> lines;
    IdVector<ArcId, Arc> arcs;
    IdVector<JunctionId, Junction> junctions; ///< ascending by vertex
    /// The junction between an arc and the next on its line; invalid for the last arc of a line.
    IdVector<ArcId, JunctionId> junctionAfter;

    [[nodiscard]] const Line& lineOf(ArcId arc) const { return lines[arcs[arc].line]; }
};

/// The junctions on a line in its direction, those included at which it begins or ends.
[[nodiscard]] std::vector<JunctionId> junctionsOf(const ArcGraph& graph, LineId line);

/// Of every arc, whether a graph has it.
using PresentArcs = IdVector<ArcId, bool>;

/// \param complex  its separatrices become lines, in the order of their lower ids
/// \param labels   sub-mesh of every vertex; both ends of an edge between two sub-meshes become stops. May be
/// empty.
[[nodiscard]] ArcGraph buildArcGraph(const QuadMesh& mesh, const BaseComplex& complex,
                                     const std::vector<SubMeshId>& labels = {});

/// Consecutive arcs of one line.
struct ArcRun {
    ArcId first;
    int count = 0;

    [[nodiscard]] ArcId last() const { return first + (count - 1); }
    [[nodiscard]] IdRange<ArcId> arcs() const { return {first, first + count}; }
};

/// The arcs of a line for which a condition holds, as maximal runs in its direction.
template <class Condition>
[[nodiscard]] std::vector<ArcRun> runsOf(const Line& line, const Condition& holds) {
    std::vector<ArcRun> runs;
    for (const ArcId arc : line.arcs()) {
        if (!holds(arc)) continue;
        if (runs.empty() || runs.back().last() + 1 != arc) runs.push_back({arc, 0});
        ++runs.back().count;
    }
    return runs;
}

/// The halfedges of an arc or a run of arcs, in the line's direction.
[[nodiscard]] std::span<const HalfedgeId> halfedgesOf(const ArcGraph& graph, const BaseComplex& complex,
                                                      ArcId arc);
[[nodiscard]] std::span<const HalfedgeId> halfedgesOf(const ArcGraph& graph, const BaseComplex& complex,
                                                      const ArcRun& run);

/// The arc on every edge; none for edges without a line.
[[nodiscard]] std::vector<ArcId> arcsOfEdges(const QuadMesh& mesh, const ArcGraph& graph,
                                             const BaseComplex& complex);

/// For every arc, the sum of a value over its edges.
[[nodiscard]] IdVector<ArcId, double> sumOverArcs(const QuadMesh& mesh, const ArcGraph& graph,
                                                  const BaseComplex& complex,
                                                  const std::vector<double>& perEdge);

} // namespace qm
