/// \file Which patches meet at which edge of the layout.
#pragma once

#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// An edge as one patch sees it: edge number `position` of its side `side`, walked counter-clockwise.
struct BorderPlace {
    std::size_t patch = 0;
    int side = 0;
    int position = 0;
};

/// A mesh edge on the border of segments. The second place, if there is one, sees it the other way round; it
/// may belong to the same patch. On the boundary of the mesh there is only one.
struct BorderEdge {
    HalfedgeId halfedge; ///< in the direction of the first place
    std::vector<BorderPlace> places;
};

/// Marks of the mesh's edges, by edge index.
struct BorderMarks {
    std::vector<bool> isBorder; ///< the edge lies between two patches or on the mesh boundary
    std::vector<bool> isCrease; ///< a border across which normals may differ; the mesh boundary is one
};

/// All border edges, in the order of the first segment, side and position that has them.
[[nodiscard]] std::vector<BorderEdge> borderEdges(const QuadMesh& mesh, const Layout& layout);

/// The parameters (u, v) of a patch at a distance from the beginning of one of its edges, as it walks it.
[[nodiscard]] std::array<double, 2> parametersAt(const Layout& layout, const BorderPlace& place,
                                                 double along);

} // namespace qm
