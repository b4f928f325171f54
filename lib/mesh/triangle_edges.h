/// \file Is a surface of triangles a manifold, and where does it end?
#pragma once

#include "mesh/triangles.h"

#include <cstddef>

namespace qm {

/// Checks that at most two triangles meet at every edge, and that they are oriented alike. Takes n log n
/// time.
/// \return the number of boundary loops; loops that touch count as one
/// \throw Error  with the place of the first such edge, and how many there are
std::size_t validateTriangleEdges(const Triangles& triangles);

} // namespace qm
