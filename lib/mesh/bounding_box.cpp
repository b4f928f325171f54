#include "mesh/bounding_box.h"

#include "base/infinity.h"

namespace qm {

BoundingBox boundingBox(const QuadMesh& mesh) {
    if (mesh.n_faces() == 0) return {};
    BoundingBox box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    for (const VertexId vertex : mesh.vertices())
        if (!mesh.is_isolated(vertex)) box.include(mesh.point(vertex));
    return box;
}

} // namespace qm
