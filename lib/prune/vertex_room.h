/// \file How many borders may be removed at an extraordinary vertex (docs/METHOD.md#pruning, smoothness).
#pragma once

#include "mesh/quad_mesh.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Consecutive edges that leave a vertex inside one tangent plane: those between two sharp edges, or all
/// edges.
struct RoomSector {
    std::vector<HalfedgeId> edges;
    std::size_t maxMissing = 0; ///< so many edges need not be borders, if no two of them are neighbours
};

/// Where a border ends, the side of a patch passes straight through the vertex and takes half a turn of its
/// tangent plane. The corners of the other patches share the rest evenly. Each of them must have at least
/// `minCorner` degrees, and at most 180 less that; a side that is left alone, without corners beside it, may
/// turn by 90 degrees at most. Between two sharp edges (or the mesh boundary) there is no common tangent
/// plane, and the angles are those of the mesh.
/// \param dihedralAngles  by edge index, radians
/// \param vertex          extraordinary
/// \param minCorner       0 to 90; 0 allows any number of missing borders
[[nodiscard]] std::vector<RoomSector> roomAt(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                                             VertexId vertex, double minCorner);

} // namespace qm
