/// \file The layout in which every quad is a segment.
#pragma once

#include "layout/layout.h"
#include "mesh/quad_mesh.h"

namespace qm::test {

/// Segment k is face k; its first corner is where the face's own halfedge begins.
[[nodiscard]] Layout segmentPerQuad(const QuadMesh& mesh);

} // namespace qm::test
