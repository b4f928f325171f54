/// \file Work on every vertex, edge or face of a mesh on several threads; see `parallelForMany`.
#pragma once

#include "base/parallel.h"
#include "mesh/quad_mesh.h"

#include <cstddef>

namespace qm {

template <class Function> void parallelForVertices(const QuadMesh& mesh, unsigned jobs, const Function& f) {
    parallelForMany(mesh.n_vertices(), jobs, [&](std::size_t k) { f(VertexId(static_cast<int>(k))); });
}

template <class Function> void parallelForEdges(const QuadMesh& mesh, unsigned jobs, const Function& f) {
    parallelForMany(mesh.n_edges(), jobs, [&](std::size_t k) { f(EdgeId(static_cast<int>(k))); });
}

template <class Function> void parallelForFaces(const QuadMesh& mesh, unsigned jobs, const Function& f) {
    parallelForMany(mesh.n_faces(), jobs, [&](std::size_t k) { f(FaceId(static_cast<int>(k))); });
}

} // namespace qm
