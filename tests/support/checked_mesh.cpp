#include "support/checked_mesh.h"

namespace qm::test {

check::CheckedMesh checkedMesh(const QuadMesh& mesh) {
    check::CheckedMesh result;
    for (const auto vertex : mesh.vertices())
        result.points.push_back({mesh.point(vertex)[0], mesh.point(vertex)[1], mesh.point(vertex)[2]});
    for (const auto face : mesh.faces()) {
        auto corner = result.quads.emplace_back().begin();
        for (const auto vertex : mesh.fv_range(face))
            *corner++ = vertex.idx();
    }
    return result;
}

} // namespace qm::test
