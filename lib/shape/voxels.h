/// \file Solids made of unit cubes, and their surfaces.
#pragma once

#include "shape/quad_list.h"

#include <array>
#include <set>

namespace qm {

using Voxel = std::array<int, 3>;
using Voxels = std::set<Voxel>;

/// All voxels from (0, 0, 0) to (x, y, z), exclusive.
[[nodiscard]] Voxels voxelBox(int x, int y, int z);

/// The squares between the solid and its outside. Voxel (i, j, k) reaches from there to (i+1, j+1, k+1).
[[nodiscard]] QuadList voxelSurface(const Voxels& voxels);

/// Whether the surface is a manifold around the corners of this voxel.
[[nodiscard]] bool surfaceIsManifoldAt(const Voxels& voxels, const Voxel& voxel);

} // namespace qm
