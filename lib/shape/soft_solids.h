/// \file Soft and random shapes: softened surfaces of voxel solids.
#pragma once

#include "shape/quad_list.h"

#include <cstdint>

namespace qm {

// n is the number of quads along each voxel's edge.

/// A slab with `holes` holes in a row, without any sharp edge.
[[nodiscard]] QuadList pretzelShape(int n, int holes);

/// A random solid of `voxels` voxels in one piece, softened a little. Its genus is random too.
[[nodiscard]] QuadList randomShape(int n, int voxels, std::uint64_t seed);

/// The same with some squares of its surface taken out: a manifold with boundary, maybe of several pieces.
[[nodiscard]] QuadList randomOpenShape(int n, int voxels, std::uint64_t seed);

} // namespace qm
