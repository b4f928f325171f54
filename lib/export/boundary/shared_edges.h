/// \file The edges that the patches of a layout share: its topology, without any solid modelling library.
#pragma once

#include "bspline/network/borders.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// A run of border edges between two vertices where borders meet, either smooth throughout or nowhere.
struct SharedEdge {
    std::vector<BorderPlace> places; ///< its first border edge as seen by each patch: one or two
    int length = 0;                  ///< number of border edges
    VertexId start;                  ///< in the direction of the first place
    VertexId end;
    double gap = 0;   ///< largest distance between the two patches
    double angle = 0; ///< largest between their normals along the edge, in degrees; 0 on the boundary
};

/// One use of a shared edge by a side of a patch.
struct EdgeUse {
    std::size_t edge = 0;
    bool forwards = true; ///< in the edge's own direction

    /// The number of the end at which it begins, and of the face among those of the edge.
    [[nodiscard]] std::size_t side() const { return forwards ? 0 : 1; }
};

struct SharedEdges {
    std::vector<SharedEdge> edges;
    /// By patch: its uses of edges, counter-clockwise from its corner 0.
    std::vector<std::vector<EdgeUse>> ofPatch;
    /// By vertex index: the mean of the ends of edges at the vertex; meaningless inside edges.
    std::vector<Point> vertexPoint;
};

/// \param patches  by segment, each over its segment's grid; none touches itself
[[nodiscard]] SharedEdges shareEdges(const QuadMesh& mesh, const Layout& layout,
                                     const std::vector<Patch>& patches);

} // namespace qm
