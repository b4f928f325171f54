/// \file Pairs of the faces around an edge (docs/METHOD.md#repairing-scans).
#pragma once

#include "mesh/orientation.h"
#include "mesh/quad_mesh.h"

#include <span>
#include <utility>
#include <vector>

namespace qm {

/// A face at an edge.
struct FaceAtEdge {
    Side side = 0;        ///< of the face, on the edge
    bool ascends = false; ///< whether that side runs in the edge's direction
    Point inward;         ///< from the edge into the face; 0 if the face has no area
};

/// Pairs of sides whose faces bound what is inside of a surface: seen along the edge, that is clockwise of
/// faces that ascend and counter-clockwise of the others. So pairs match like brackets, and all faces are in
/// one if as many ascend as not.
/// \param direction  of the edge, of any length
[[nodiscard]] std::vector<std::pair<Side, Side>> pairsAroundSolids(const Point& direction,
                                                                   std::span<const FaceAtEdge> faces);

} // namespace qm
