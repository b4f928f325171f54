#include "mesh/turned_over.h"

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "mesh/quad_geometry.h"

#include <array>
#include <optional>
#include <utility>

namespace qm {

std::vector<FaceId> turnedOverQuads(const QuadMesh& mesh) {
    constexpr double opposite = -0.9; // cosine
    constexpr std::size_t few = 4;    // times as many beyond the fold
    std::vector<std::optional<Point>> normals;
    for (const FaceId face : mesh.faces())
        normals.push_back(middleNormal(mesh, face));
    DisjointSets parts(mesh.n_faces());
    std::vector<std::array<std::size_t, 2>> folds;
    for (const EdgeId edge : mesh.edges()) {
        if (mesh.is_boundary(edge)) continue;
        const std::size_t one = at(mesh.face_handle(mesh.halfedge_handle(edge, 0)));
        const std::size_t other = at(mesh.face_handle(mesh.halfedge_handle(edge, 1)));
        if (normals[one] && normals[other] && (*normals[one] | *normals[other]) < opposite)
            folds.push_back({one, other});
        else
            parts.join(one, other);
    }
    if (folds.empty()) return {};

    std::vector<std::size_t> sizes(mesh.n_faces());
    for (std::size_t face = 0; face < sizes.size(); ++face)
        ++sizes[parts.find(face)];
    enum class Fold : char { none, ofFew, other };
    std::vector<Fold> foldOf(mesh.n_faces(), Fold::none); // by part
    for (const auto& [one, other] : folds)
        for (const auto& [part, beyond] : {std::pair(one, other), std::pair(other, one)}) {
            Fold& fold = foldOf[parts.find(part)];
            const bool isFew = few * sizes[parts.find(part)] <= sizes[parts.find(beyond)];
            if (!isFew) fold = Fold::other;
            if (isFew && fold == Fold::none) fold = Fold::ofFew;
        }
    std::vector<FaceId> turned;
    for (const FaceId face : mesh.faces())
        if (foldOf[parts.find(at(face))] == Fold::ofFew) turned.push_back(face);
    return turned;
}

} // namespace qm
