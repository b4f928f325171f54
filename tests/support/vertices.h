/// \file All vertices of a mesh, as a list.
#pragma once

#include "mesh/quad_mesh.h"

#include <vector>

namespace qm::test {

inline std::vector<VertexId> verticesOf(const QuadMesh& mesh) {
    std::vector<VertexId> vertices;
    vertices.reserve(mesh.n_vertices());
    for (const VertexId vertex : mesh.vertices())
        vertices.push_back(vertex);
    return vertices;
}

} // namespace qm::test
