/// \file Which cells of a sub-mesh are tied by quads (docs/METHOD.md#mesh-cut).
#pragma once

#include "base/ids.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

/// Cells at the corners of a quad, around it; if there are fewer than four, the last one is repeated.
using CellTie = std::array<int, 4>;

/// The ties of all quads that have corners in several cells, each once, ascending. Corners outside the
/// sub-mesh do not count.
/// \param labels    sub-mesh of every vertex of the mesh
/// \param vertices  all vertices of one sub-mesh
/// \param cellOf    cell of every vertex of the mesh; only those of the sub-mesh count
[[nodiscard]] std::vector<CellTie> cellTies(const QuadMesh& mesh, const std::vector<SubMeshId>& labels,
                                            const std::vector<VertexId>& vertices,
                                            const std::vector<int>& cellOf);

} // namespace qm
