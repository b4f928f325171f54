/// \file Checking that a surface of triangles is a manifold, and counting its boundary loops.
#pragma once

#include "mesh/triangles.h"

#include <cstddef>

namespace qm {

/// Checks that at most two triangles meet at every edge, and that neighbours are oriented alike. Takes n log
/// n time.
/// \return the number of boundary loops; loops that touch count as one
/// \throw Error  with the first faulty edge and the number of such edges
std::size_t validateTriangleEdges(const Triangles& triangles);

} // namespace qm
