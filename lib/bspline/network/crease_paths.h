/// \file The creases of a layout, as paths along the mesh.
#pragma once

#include "bspline/network/borders.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// The creases between patches, without the mesh boundary, as lists of vertices: each path goes on as long as
/// exactly two creases meet. A closed one ends where it begins. Linear in the mesh.
[[nodiscard]] std::vector<std::vector<VertexId>> creasePaths(const QuadMesh& mesh, const BorderMarks& marks);

} // namespace qm
