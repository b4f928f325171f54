/// \file The layout that makes a segment of every quad.
#pragma once

#include "layout/layout.h"
#include "mesh/quad_mesh.h"

namespace qm::testing {

/// Segment k is face k, its first corner where the face's own halfedge begins.
[[nodiscard]] Layout segmentPerQuad(const QuadMesh& mesh);

} // namespace qm::testing
