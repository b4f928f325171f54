#include "bspline/splines/bounding_box.h"

#include <limits>

namespace qm {

double boundingBoxDiagonal(const QuadMesh& mesh) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Point low(infinity, infinity, infinity);
    Point high = -low;
    for (const FaceId face : mesh.faces())
        for (const VertexId vertex : mesh.fv_range(face)) {
            low.minimize(mesh.point(vertex));
            high.maximize(mesh.point(vertex));
        }
    return mesh.n_faces() == 0 ? 0 : (high - low).norm();
}

} // namespace qm
