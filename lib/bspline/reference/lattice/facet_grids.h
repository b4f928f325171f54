/// \file The quads of a mesh as a reference.
#pragma once

#include "bspline/reference/lattice/reference_grid.h"
#include "layout/layout.h"

#include <vector>

namespace qm {

/// By segment: its quads, bilinear.
[[nodiscard]] std::vector<ReferenceGrid> facetGrids(const QuadMesh& mesh, const Layout& layout);

} // namespace qm
