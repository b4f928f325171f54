/// \file The edges that the patches of a layout share: its topology, without any library of solids.
#pragma once

#include "bspline/network/borders.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// A run of border edges between two vertices where borders meet, smooth throughout or nowhere.
struct SharedEdge {
    std::vector<BorderPlace> places; ///< of its first border edge as each patch walks it: one or two
    int length = 0;                  ///< in border edges
    VertexId start;                  ///< in the direction of the first place
    VertexId end;
    double gap = 0;   ///< between the two patches
    double angle = 0; ///< largest between their normals along the edge, in degrees; 0 on the boundary
};

/// One use of a shared edge by a side of a patch.
struct EdgeUse {
    std::size_t edge = 0;
    bool forwards = true; ///< in the edge's own direction
};

struct SharedEdges {
    std::vector<SharedEdge> edges;
    /// The uses of each patch, counter-clockwise from its corner 0.
    std::vector<std::vector<EdgeUse>> ofPatch;
    /// The middle of where edges end at each vertex, by vertex index; of no meaning inside edges.
    std::vector<Point> vertexPoint;
};

/// \param patches  in the order of the segments, each with its segment's grid as its domain; none touches
/// itself
[[nodiscard]] SharedEdges shareEdges(const QuadMesh& mesh, const Layout& layout,
                                     const std::vector<Patch>& patches);

/// Which connected component each patch belongs to, numbered in the order of the patches.
[[nodiscard]] std::vector<std::size_t> patchComponents(const SharedEdges& shared);

} // namespace qm
