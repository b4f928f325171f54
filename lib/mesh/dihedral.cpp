#include "mesh/dihedral.h"

#include <array>
#include <cmath>

namespace qm {
namespace {

/// Unit vector, or zero for a vector without length.
Point unit(const Point& vector) {
    const double length = vector.norm();
    return length > 0 ? vector / length : Point(0, 0, 0);
}

Point faceNormal(const QuadMesh& mesh, FaceId face) {
    std::array<Point, 4> corners;
    HalfedgeId halfedge = mesh.halfedge_handle(face); // points to the face's first vertex
    for (Point& corner : corners) {
        corner = mesh.point(mesh.to_vertex_handle(halfedge));
        halfedge = mesh.next_halfedge_handle(halfedge);
    }
    const auto& [a, b, c, d] = corners;
    return unit(unit((b - a) % (c - a)) + unit((c - a) % (d - a)));
}

} // namespace

std::vector<double> dihedralAngles(const QuadMesh& mesh) {
    std::vector<Point> normals;
    normals.reserve(mesh.n_faces());
    for (const FaceId face : mesh.faces())
        normals.push_back(faceNormal(mesh, face));
    std::vector<double> angles(mesh.n_edges(), 0);
    for (const EdgeId edge : mesh.edges()) {
        if (mesh.is_boundary(edge)) continue;
        const auto normal = [&](unsigned side) {
            return normals[static_cast<std::size_t>(
                mesh.face_handle(mesh.halfedge_handle(edge, side)).idx())];
        };
        const Point a = normal(0), b = normal(1);
        if (a.sqrnorm() == 0 || b.sqrnorm() == 0) continue;
        angles[static_cast<std::size_t>(edge.idx())] = std::atan2((a % b).norm(), a | b);
    }
    return angles;
}

std::vector<double> edgeCosts(const std::vector<double>& dihedralAngles, const CostOptions& options) {
    std::vector<double> costs;
    costs.reserve(dihedralAngles.size());
    for (const double angle : dihedralAngles)
        costs.push_back(-angle + (angle < options.epsilon ? options.alpha : 0));
    return costs;
}

} // namespace qm
