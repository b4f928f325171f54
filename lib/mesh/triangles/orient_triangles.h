/// \file Turning the triangles of a surface so that neighbours agree.
#pragma once

#include "mesh/triangles/triangles.h"

#include <cstddef>

namespace qm {

/// Turns triangles over so that those on both sides of every edge of two agree; every component is turned
/// like the majority of its triangles. Takes n log n time.
/// \return how many were turned
/// \throw Error  with the place, if the surface is one-sided; nothing is turned then
std::size_t orientTriangles(Triangles& triangles);

} // namespace qm
