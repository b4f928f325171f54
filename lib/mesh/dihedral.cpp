#include "mesh/dihedral.h"

#include "base/at.h"
#include "mesh/angle_between.h"
#include "mesh/quad_geometry.h"
#include "mesh/topology.h"

namespace qm {

std::vector<double> dihedralAngles(const QuadMesh& mesh) {
    std::vector<std::optional<Point>> normals;
    normals.reserve(mesh.n_faces());
    for (const FaceId face : mesh.faces())
        normals.push_back(quadNormal(mesh, face));
    std::vector<double> angles(mesh.n_edges(), 0);
    for (const EdgeId edge : mesh.edges()) {
        if (mesh.is_boundary(edge)) continue;
        const auto [left, right] = facesBeside(mesh, edge);
        if (const auto& a = normals[at(left)], &b = normals[at(right)]; a && b)
            angles[at(edge)] = angleBetween(*a, *b);
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
