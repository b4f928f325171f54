/// \file The base complex as arcs and junctions: what the search works on (method 2, "The same, on arcs").
#pragma once

#include "base/ids.h"
#include "basecomplex/base_complex.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <optional>
#include <vector>

namespace qm {

/// An undirected separatrix. Its arcs are consecutive: firstArc .. firstArc + arcCount - 1, in the direction
/// of `forward`.
struct Line {
    SeparatrixId forward;                 ///< of the two directions the one with the lower id
    std::optional<SeparatrixId> backward; ///< its opposite; none if only one particle runs on the line
    ArcId firstArc;
    int arcCount = 0;
};

/// The part of a line between successive junctions.
struct Arc {
    LineId line;
    int begin = 0; ///< half-open range of halfedges of the line's forward separatrix
    int end = 0;
};

/// A regular vertex where two lines cross. `arcs[0]` and `arcs[2]` go straight on through each other, and so
/// do `arcs[1]` and `arcs[3]`. Two opposite arcs are on one line, except at a feature seed, which ends two
/// lines: then no head-on meeting is possible on that side, and both arcs are in every graph.
struct Junction {
    VertexId vertex;
    std::array<ArcId, 4> arcs;
};

struct ArcGraph {
    std::vector<Line> lines;
    std::vector<Arc> arcs;
    std::vector<Junction> junctions; ///< ascending by vertex
    /// The junction that follows an arc on its line, none at the line's end.
    std::vector<JunctionId> junctionAfter;

    [[nodiscard]] const Line &lineOf(ArcId arc) const { return lines[arcs[arc.idx()].line.idx()]; }
};

/// \param complex  the base complex whose separatrices become lines, in the order of their lower ids
[[nodiscard]] ArcGraph buildArcGraph(const QuadMesh &mesh, const BaseComplex &complex);

/// The halfedges of an arc, in the line's direction.
[[nodiscard]] std::vector<HalfedgeId> halfedgesOf(const ArcGraph &graph, const BaseComplex &complex,
                                                  ArcId arc);

/// Sum of a value per edge over every arc.
[[nodiscard]] std::vector<double> sumOverArcs(const QuadMesh &mesh, const ArcGraph &graph,
                                              const BaseComplex &complex, const std::vector<double> &perEdge);

} // namespace qm
