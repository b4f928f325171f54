/// \file The outlines of simple faces in their parameter planes.
#pragma once

#include "export/boundary/boundary.h"

#include <cstddef>

namespace qm {

/// Whether a loop of a simple face crosses itself in the face's parameter plane: programs make no triangles
/// of it, although OpenCASCADE's check finds no fault where the crossing is within the tolerance of an edge.
[[nodiscard]] bool outlineCrossesItself(const Boundary& boundary, std::size_t face);

} // namespace qm
