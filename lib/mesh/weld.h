/// \file Which vertices of a soup are one.
#pragma once

#include "mesh/soup.h"

#include <vector>

namespace qm {

// Of a soup whose polygons are quads of four different vertices, with indices in range and finite
// coordinates. Two points lie at the same place if no coordinate differs by more than 1e-9 of the longest
// side of the faces' bounding box.

/// For every vertex the lowest one it may be welded to: at the same place, both on the border of some
/// face that has no neighbour there, and not the two ends of a side. Vertices that lie at one place for
/// another reason, interior ones say, are left alone: welding them would only make the surface worse.
[[nodiscard]] std::vector<std::size_t> weldTargets(const Soup& soup);

/// Quads to be collapsed because two opposite corners, at least one of them interior, lie at the same place.
struct Collapses {
    std::vector<bool> faceStays;
    std::vector<std::size_t> target; ///< for every vertex the one it becomes
};

/// Only where the surface stays a manifold, and no two next to each other.
[[nodiscard]] Collapses findCollapses(const Soup& soup);

} // namespace qm
