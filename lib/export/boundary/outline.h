/// \file The outlines of simple faces in their parameter planes.
#pragma once

#include "export/boundary/boundary.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Whether a loop of a simple face crosses itself in the face's parameter plane: programs make no triangles
/// of it, although OpenCASCADE's check finds no fault where the crossing is within the tolerance of an edge.
[[nodiscard]] bool outlineCrossesItself(const Boundary& boundary, std::size_t face);

/// The edges of loops that make no outline: those that cross one another, unless one follows the other, and
/// those of holes that are turned over.
[[nodiscard]] std::vector<std::size_t> faultyEdges(const Boundary& boundary, std::size_t face);

} // namespace qm
