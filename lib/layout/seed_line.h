/// \file The line that becomes the first track of a component without sources (docs/METHOD.md#layout).
#pragma once

#include "mesh/quad_mesh.h"

#include <span>
#include <vector>

namespace qm {

/// The whole mesh line over the most curved interior edge of some faces; ties go to the lowest edge. It is a
/// loop, or leads from boundary to boundary.
/// \param faces  at least one, in a component whose vertices are all regular
[[nodiscard]] std::vector<HalfedgeId> seedLine(const QuadMesh& mesh, std::span<const FaceId> faces,
                                               const std::vector<double>& dihedralAngles);

} // namespace qm
