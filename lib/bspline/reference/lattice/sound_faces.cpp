#include "bspline/reference/lattice/sound_faces.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/reference/lattice/bilinear_quad.h"
#include "mesh/quad_geometry.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace qm {
namespace {

/// What decides on a quad and its neighbours.
struct QuadShape {
    Point normal; ///< unit, in the middle
    double minCosine = 0;
};

std::vector<QuadShape> shapesOf(const QuadMesh& mesh, unsigned jobs) {
    std::vector<QuadShape> shapes(mesh.n_faces());
    parallelForMany(shapes.size(), jobs, [&](std::size_t k) {
        std::array<Point, 4> corners;
        std::ranges::transform(cornersOf(mesh, FaceId(static_cast<int>(k))), corners.begin(),
                               [&](VertexId vertex) { return mesh.point(vertex); });
        const BilinearQuad quad(corners);
        shapes[k] = {quad.normal(), quad.minCosine()};
    });
    return shapes;
}

/// By face: whether it is turned over, in itself or against a face beside it.
std::vector<bool> turnedOverFaces(const QuadMesh& mesh, const std::vector<QuadShape>& shapes) {
    constexpr double turnedOver = -0.5; // cosine between faces that share an edge
    std::vector<bool> isTurnedOver(mesh.n_faces());
    for (std::size_t face = 0; face < shapes.size(); ++face)
        isTurnedOver[face] = !(shapes[face].minCosine > 0);
    for (const EdgeId edge : mesh.edges()) {
        if (mesh.is_boundary(edge)) continue;
        const std::size_t one = at(mesh.face_handle(mesh.halfedge_handle(edge, 0)));
        const std::size_t other = at(mesh.face_handle(mesh.halfedge_handle(edge, 1)));
        if ((shapes[one].normal | shapes[other].normal) < turnedOver)
            isTurnedOver[one] = isTurnedOver[other] = true;
    }
    return isTurnedOver;
}

} // namespace

std::vector<bool> uprightFaces(const QuadMesh& mesh, unsigned jobs) {
    const std::vector<QuadShape> shapes = shapesOf(mesh, jobs);
    std::vector<bool> isUpright = turnedOverFaces(mesh, shapes);
    isUpright.flip();
    for (std::size_t face = 0; face < shapes.size(); ++face)
        if (!(shapes[face].minCosine > notFolded)) isUpright[face] = false;
    return isUpright;
}

std::vector<bool> soundFaces(const QuadMesh& mesh, unsigned jobs, double minCosine) {
    const std::vector<QuadShape> shapes = shapesOf(mesh, jobs);
    const std::vector<bool> isTurnedOver = turnedOverFaces(mesh, shapes);
    std::vector<bool> isSound(mesh.n_faces());
    for (std::size_t face = 0; face < shapes.size(); ++face)
        isSound[face] = shapes[face].minCosine > minCosine;
    for (const FaceId face : mesh.faces()) {
        if (!isTurnedOver[at(face)]) continue;
        for (const VertexId vertex : mesh.fv_range(face))
            for (const FaceId beside : mesh.vf_range(vertex))
                isSound[at(beside)] = false;
    }
    return isSound;
}

std::vector<bool> soundVertices(const QuadMesh& mesh, unsigned jobs, double minCosine) {
    const std::vector<bool> isSound = soundFaces(mesh, jobs, minCosine);
    std::vector<bool> result(mesh.n_vertices(), true);
    for (const FaceId face : mesh.faces()) {
        if (isSound[at(face)]) continue;
        for (const VertexId vertex : mesh.fv_range(face))
            result[at(vertex)] = false;
    }
    return result;
}

} // namespace qm
