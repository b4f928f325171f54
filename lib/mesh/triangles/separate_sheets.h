/// \file Separating the sheets of a surface of triangles where they touch (docs/METHOD.md#repairing-scans).
#pragma once

#include "mesh/triangles/triangles.h"

#include <cstddef>

namespace qm {

struct SeparatedSheets {
    std::size_t edges = 0;  ///< edges at which more than two triangles met
    std::size_t points = 0; ///< points at which several sheets met, those of such edges among them
};

/// Divides the triangles at every edge into pairs and gives every sheet of triangles around a point,
/// connected by such pairs, a point of its own, so that at most two triangles meet at every edge. Where the
/// orientations are balanced, pairs bound what is inside of the surface; of three triangles, the two that
/// bend the least are a pair. Edges that are still shared get a point in their middle. Takes n log n time.
/// \param triangles  neighbours agree in orientation
SeparatedSheets separateSheets(Triangles& triangles);

} // namespace qm
