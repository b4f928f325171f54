#include "bspline/reference/lattice/sound_faces.h"

#include "base/at.h"
#include "bspline/reference/lattice/bilinear_quad.h"
#include "mesh/parallel_elements.h"
#include "mesh/quad_geometry.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cstddef>

namespace qm {
namespace {

/// What decides on a quad and its neighbours.
struct QuadShape {
    Point normal; ///< unit, in the middle
    double minCosine = 0;
    bool hasArea = false; ///< seen along its normal
};

std::vector<QuadShape> shapesOf(const QuadMesh& mesh, unsigned jobs) {
    std::vector<QuadShape> shapes(mesh.n_faces());
    parallelForFaces(mesh, jobs, [&](FaceId face) {
        const auto corners = cornerPoints(mesh, face);
        const BilinearQuad quad(corners);
        const Point across = corners[2] - corners[0], along = corners[3] - corners[1];
        const double length = std::max(across.norm(), along.norm());
        constexpr double minShare = 1e-6; // with less, the normal is that of rounding
        shapes[at(face)] = {quad.normal(), quad.minCosine(),
                            (across % along).norm() > minShare * length * length};
    });
    return shapes;
}

/// Calls back with both faces of every inner edge, and the cosine between their normals.
template <class Callback>
void forNeighbours(const QuadMesh& mesh, const std::vector<QuadShape>& shapes, Callback callback) {
    for (const EdgeId edge : mesh.edges()) {
        if (mesh.is_boundary(edge)) continue;
        const auto [one, other] = facesBeside(mesh, edge);
        callback(edge, at(one), at(other), shapes[at(one)].normal | shapes[at(other)].normal);
    }
}

/// Sets everything around chosen faces, and these, to false.
template <class IsChosen>
void clearAround(const QuadMesh& mesh, IsChosen isChosen, std::vector<bool>& byFace) {
    for (const FaceId face : mesh.faces()) {
        if (!isChosen(at(face))) continue;
        for (const VertexId vertex : mesh.fv_range(face))
            for (const FaceId beside : mesh.vf_range(vertex))
                byFace[at(beside)] = false;
    }
}

constexpr double turnedOver = -0.5; // cosine between faces that share an edge

} // namespace

std::vector<bool> uprightFaces(const QuadMesh& mesh, const std::vector<bool>& sharp, unsigned jobs) {
    const std::vector<QuadShape> shapes = shapesOf(mesh, jobs);
    std::vector<bool> isUpright(mesh.n_faces());
    for (std::size_t face = 0; face < shapes.size(); ++face)
        isUpright[face] = shapes[face].minCosine > notFolded;
    forNeighbours(mesh, shapes, [&](EdgeId edge, std::size_t one, std::size_t other, double cosine) {
        if (cosine < (sharp[at(edge)] ? turnedOver : 0)) isUpright[one] = isUpright[other] = false;
    });
    clearAround(
        mesh, [&](std::size_t face) { return !shapes[face].hasArea; }, isUpright);
    return isUpright;
}

std::vector<bool> soundFaces(const QuadMesh& mesh, unsigned jobs, double minCosine) {
    const std::vector<QuadShape> shapes = shapesOf(mesh, jobs);
    std::vector<bool> isSound(mesh.n_faces());
    std::vector<bool> isTurnedOver(mesh.n_faces());
    for (std::size_t face = 0; face < shapes.size(); ++face) {
        isSound[face] = shapes[face].minCosine > minCosine;
        isTurnedOver[face] = !(shapes[face].minCosine > 0);
    }
    forNeighbours(mesh, shapes, [&](EdgeId, std::size_t one, std::size_t other, double cosine) {
        if (cosine < turnedOver) isTurnedOver[one] = isTurnedOver[other] = true;
    });
    clearAround(
        mesh, [&](std::size_t face) { return isTurnedOver[face]; }, isSound);
    return isSound;
}

std::vector<bool> shrunk(const QuadMesh& mesh, std::vector<bool> faces, int rings) {
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<bool> before = faces;
        clearAround(
            mesh, [&](std::size_t face) { return !before[face]; }, faces);
    }
    return faces;
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
