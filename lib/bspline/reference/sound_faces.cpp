#include "bspline/reference/sound_faces.h"

#include "base/at.h"

#include <algorithm>
#include <cstddef>

namespace qm {

namespace {

BilinearQuad quadOf(const QuadMesh& mesh, FaceId face) {
    std::array<Point, 4> corners;
    std::ranges::transform(mesh.fv_ccw_range(face), corners.begin(),
                           [&](VertexId vertex) { return mesh.point(vertex); });
    return BilinearQuad(corners);
}

} // namespace

BilinearQuad::BilinearQuad(const std::array<Point, 4>& corners)
    : corners_(corners), normal_(unit((corners[2] - corners[0]) % (corners[3] - corners[1]))) {}

SurfacePoint BilinearQuad::evaluate(double s, double t) const {
    const auto& [a, b, c, d] = corners_;
    SurfacePoint point;
    point.position = (1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * d + s * c);
    point.du = (1 - t) * (b - a) + t * (c - d);
    point.dv = (1 - s) * (d - a) + s * (c - b);
    return point;
}

double BilinearQuad::minCosine() const {
    double min = 1;
    for (std::size_t k = 0; k < 4; ++k)
        min = std::min(min, normal_ | unit((corners_[(k + 1) % 4] - corners_[k]) %
                                           (corners_[(k + 3) % 4] - corners_[k])));
    return min;
}

std::vector<bool> soundFaces(const QuadMesh& mesh, double minCosine) {
    constexpr double turnedOver = -0.5; // cosine between faces that share an edge
    std::vector<bool> isSound(mesh.n_faces());
    std::vector<bool> isTurnedOver(mesh.n_faces());
    for (const FaceId face : mesh.faces()) {
        const double cosine = quadOf(mesh, face).minCosine();
        isSound[at(face)] = cosine > minCosine;
        if (!(cosine > 0)) isTurnedOver[at(face)] = true;
    }
    for (const EdgeId edge : mesh.edges()) {
        if (mesh.is_boundary(edge)) continue;
        const FaceId one = mesh.face_handle(mesh.halfedge_handle(edge, 0));
        const FaceId other = mesh.face_handle(mesh.halfedge_handle(edge, 1));
        if ((quadOf(mesh, one).normal() | quadOf(mesh, other).normal()) < turnedOver)
            isTurnedOver[at(one)] = isTurnedOver[at(other)] = true;
    }
    for (const FaceId face : mesh.faces())
        for (const VertexId vertex : mesh.fv_range(face))
            for (const FaceId beside : mesh.vf_range(vertex))
                if (isTurnedOver[at(beside)]) isSound[at(face)] = false;
    return isSound;
}

std::vector<bool> soundVertices(const QuadMesh& mesh, double minCosine) {
    const std::vector<bool> isSound = soundFaces(mesh, minCosine);
    std::vector<bool> result(mesh.n_vertices(), true);
    for (const FaceId face : mesh.faces())
        for (const VertexId vertex : mesh.fv_range(face))
            if (!isSound[at(face)]) result[at(vertex)] = false;
    return result;
}

} // namespace qm
