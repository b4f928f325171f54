/// \file Making a manifold of a surface of triangles (docs/METHOD.md#repairing-scans), and two of its steps,
/// in sources of their own: orient_triangles and separate_sheets.
#pragma once

#include "mesh/triangles/triangles.h"

#include <cstddef>

namespace qm {

struct TriangleRepair {
    std::size_t doubledTriangles = 0; ///< triangles dropped because others have the same points
    std::size_t turnedTriangles = 0;  ///< triangles whose orientation was reversed
    std::size_t crowdedEdges = 0;     ///< edges at which more than two triangles met
    std::size_t touchingPoints = 0;   ///< points in which sheets touched, also those of such edges

    friend bool operator==(const TriangleRepair&, const TriangleRepair&) = default;
};

/// Makes the surface a manifold whose triangles agree in orientation. The shape stays: of triangles with the
/// same points one is left, or none where two form a flap on a surface that is whole without it; every
/// component is turned like the majority of its triangles; and sheets that touch are separated (see
/// `separateSheets`). Takes n log n time.
/// \throw Error  with the place, if the surface is one-sided
TriangleRepair repairTriangles(Triangles& triangles);

/// Turns triangles over so that those on both sides of every edge of two agree; every component is turned
/// like the majority of its triangles. Takes n log n time.
/// \return how many were turned
/// \throw Error  with the place, if the surface is one-sided; nothing is turned then
std::size_t orientTriangles(Triangles& triangles);

/// Divides the triangles at every edge into pairs and gives every sheet of triangles around a point,
/// connected by such pairs, a point of its own, so that at most two triangles meet at every edge. Where the
/// orientations are balanced, pairs bound what is inside of the surface; of three triangles, the two that
/// bend the least are a pair. Edges that are still shared get a point in their middle. Takes n log n time.
/// \param triangles  neighbours agree in orientation
/// \param report     gets the numbers of crowded edges and of touching points
void separateSheets(Triangles& triangles, TriangleRepair& report);

} // namespace qm
