/// \file The layout of the cheapest motorcycle graph of a whole mesh.
#pragma once

#include "layout/layout.h"

namespace qm::test {

[[nodiscard]] Layout cheapestLayout(const QuadMesh& mesh);

} // namespace qm::test
