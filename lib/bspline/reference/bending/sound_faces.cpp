#include "bspline/reference/bending/sound_faces.h"

#include "base/at.h"
#include "bspline/reference/lattice/bilinear_quad.h"
#include "mesh/quad_geometry.h"

#include <algorithm>
#include <array>

namespace qm {
namespace {

BilinearQuad quadOf(const QuadMesh& mesh, FaceId face) {
    std::array<Point, 4> corners;
    std::ranges::transform(cornersOf(mesh, face), corners.begin(),
                           [&](VertexId vertex) { return mesh.point(vertex); });
    return BilinearQuad(corners);
}

} // namespace

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
