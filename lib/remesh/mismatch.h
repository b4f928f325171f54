/// \file What a remesher left out of a scan, and where it strayed from it.
#pragma once

#include "mesh/quad_mesh.h"
#include "mesh/triangles/triangles.h"

namespace qm {

struct Mismatch {
    double missing = 0;         ///< share of the scan's area that is too far from the quads, 0 to 1
    Point missingAt{0, 0, 0};   ///< the place of the scan that is farthest from them, and
    double missingDistance = 0; ///< its distance
    double strayed = 0;         ///< the largest distance of a vertex from the scan, if it is too far; or 0
    Point strayedAt{0, 0, 0};   ///< that vertex
};

/// Compares a quad mesh with the scan that it was made of. Too far is more than two of the mesh's mean edges:
/// so rounded edges and closed holes do not count, but parts that are missing do.
/// \param jobs  threads; the result does not depend on their number
[[nodiscard]] Mismatch mismatchOf(const QuadMesh& mesh, const Triangles& scan, unsigned jobs);

} // namespace qm
