/// \file How much may be removed at an extraordinary vertex (docs/METHOD.md#pruning, smoothness).
#pragma once

#include "mesh/quad_mesh.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Consecutive edges that leave a vertex inside one tangent plane: between two sharp ones, or all of them.
struct RoomSector {
    std::vector<HalfedgeId> edges;
    std::size_t maxMissing = 0; ///< so many of them need be no borders, if no two neighbours are
};

/// Where a border ends, a patch's side passes straight through the vertex and takes half a turn of its
/// tangent plane. What is left is for the corners of the other patches, which share it evenly: each is to get
/// `minCorner` degrees at least, and as much less than half a turn at most. Without a smooth tangent plane,
/// between sharp edges (the mesh boundary is one), there is as much as the mesh has.
/// \param dihedralAngles  by edge index, radians
/// \param vertex  extraordinary
/// \param minCorner  0 to 90; 0: as many may be missing as there are
[[nodiscard]] std::vector<RoomSector> roomAt(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                                             VertexId vertex, double minCorner);

} // namespace qm
