/// \file The line that a component without any source gets (docs/METHOD.md#layout).
#pragma once

#include "mesh/quad_mesh.h"

#include <span>
#include <vector>

namespace qm {

/// The whole mesh line over the most curved interior edge of some faces, ties by the lowest: a loop, or from
/// boundary to boundary.
/// \param faces  at least one, of a component whose vertices are all regular
[[nodiscard]] std::vector<HalfedgeId> seedLine(const QuadMesh& mesh, std::span<const FaceId> faces,
                                               const std::vector<double>& dihedralAngles);

} // namespace qm
