/// \file Making a manifold of a surface of triangles (docs/METHOD.md#repairing-scans).
#pragma once

#include "mesh/triangles/triangles.h"

#include <cstddef>

namespace qm {

struct TriangleRepair {
    std::size_t doubledTriangles = 0; ///< triangles dropped because others have the same points
    std::size_t turnedTriangles = 0;  ///< triangles whose orientation was reversed
    std::size_t crowdedEdges = 0;     ///< edges at which more than two triangles met
    std::size_t touchingPoints = 0;   ///< points in which sheets of the surface touched

    friend bool operator==(const TriangleRepair&, const TriangleRepair&) = default;
};

/// Makes the surface a manifold whose triangles agree in orientation. The shape stays: of triangles with the
/// same points one is left, or none where two form a flap on a surface that is whole without it; every
/// component is turned like the majority of its triangles; and sheets that touch are separated (see
/// `separateSheets`). Takes n log n time.
/// \throw Error  with the place, if the surface is one-sided
TriangleRepair repairTriangles(Triangles& triangles);

} // namespace qm
