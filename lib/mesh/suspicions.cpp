#include "mesh/suspicions.h"

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "mesh/nesting.h"
#include "mesh/quad_geometry.h"
#include "mesh/topology.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

namespace qm {
namespace {

/// The number of vertices at the place of an earlier one, the first such pair, and whether there may be a
/// seam: two boundary edges at one place. Surfaces that touch in single vertices have none.
struct Coincident {
    std::size_t count = 0;
    VertexId first, earlier;
    bool mayBeSeam = false;
};

Coincident coincidentVertices(const QuadMesh& mesh) {
    struct Hash {
        std::size_t operator()(const Point& point) const {
            std::size_t value = 0;
            for (const double coordinate : point)
                value = value * 0x9e3779b97f4a7c15ULL + std::hash<double>{}(coordinate);
            return value;
        }
    };
    Coincident result;
    std::unordered_map<Point, VertexId, Hash> places(mesh.n_vertices());
    for (const VertexId vertex : mesh.vertices()) {
        const auto [place, isNew] = places.emplace(mesh.point(vertex), vertex);
        if (isNew || result.count++ > 0) continue;
        result.first = vertex;
        result.earlier = place->second;
    }
    if (result.count == 0) return result;
    std::set<std::pair<VertexId, VertexId>> sides;
    for (const EdgeId edge : mesh.edges()) {
        if (!mesh.is_boundary(edge)) continue;
        const auto [a, b] = endsOf(mesh, edge);
        if (!sides.insert(std::minmax({places.at(mesh.point(a)), places.at(mesh.point(b))})).second)
            result.mayBeSeam = true;
    }
    return result;
}

/// The quads, ascending, that are turned over together with few others, or alone: where two neighbours'
/// normals are opposite, within 26 degrees, the mesh folds back on itself. Folds may be meant, such as the
/// rim of a thin fin or lens, but then what is beyond is as large, or is connected around the fold's end. So
/// the folds divide the mesh, and quads are turned over if every part that a fold separates them from has
/// four times as many.
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
        const auto [left, right] = facesBeside(mesh, edge);
        const std::size_t one = at(left), other = at(right);
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

/// The first face of every closed component that looks into the solid.
std::vector<FaceId> insideOut(const QuadMesh& mesh) {
    const std::vector<std::vector<FaceId>> closed = closedComponents(mesh);
    const std::vector<Nesting> nesting = nestingOf(mesh, closed);
    std::vector<FaceId> result;
    for (std::size_t k = 0; k < closed.size(); ++k)
        if (nesting[k].inward) result.push_back(closed[k].front());
    return result;
}

std::string of(std::size_t some, std::size_t all, const std::string& noun) {
    return std::to_string(some) + " of " + std::to_string(all) + " " + noun + " ";
}

} // namespace

std::vector<std::string> suspicions(const QuadMesh& mesh) {
    std::vector<std::string> result;
    if (const Coincident found = coincidentVertices(mesh); found.count > 0)
        result.push_back(of(found.count, mesh.n_vertices(), "vertices") +
                         (found.count == 1 ? "lies" : "lie") + " where another does: vertex " +
                         std::to_string(found.first.idx()) + " where " + std::to_string(found.earlier.idx()) +
                         (found.count == 1 ? "" : ", and so on") +
                         (found.mayBeSeam ? ". If a seam should be closed, use --repair"
                                          : ". The surface touches itself there"));
    std::vector<int> flat;
    for (const FaceId face : mesh.faces())
        if (!hasArea(mesh, face)) flat.push_back(face.idx());
    if (!flat.empty())
        result.push_back(of(flat.size(), mesh.n_faces(), "quads") + (flat.size() == 1 ? "has" : "have") +
                         " no area, the first is face " + std::to_string(flat.front()) +
                         ". Edges there count as flat; --repair takes out what has two corners at one place");
    if (const std::vector<FaceId> turned = turnedOverQuads(mesh); !turned.empty())
        result.push_back(of(turned.size(), mesh.n_faces(), "quads") + (turned.size() == 1 ? "lies" : "lie") +
                         " upside down on others, the first is face " + std::to_string(turned.front().idx()) +
                         ". The mesh is folded there: move the vertices");
    if (const std::vector<FaceId> parts = insideOut(mesh); !parts.empty())
        result.push_back(
            (parts.size() == 1
                 ? "a closed component is inside out, that"
                 : std::to_string(parts.size()) + " closed components are inside out, the first is that") +
            " of face " + std::to_string(parts.front().idx()) +
            ". Solids in STEP and IGES files are turned; for all else, reverse the mesh's faces");
    if (const std::size_t pieces = pieceCount(mesh); pieces > 10)
        result.push_back("the mesh has " + std::to_string(pieces) + " components. Should they be joined?");
    if (const std::size_t extraordinary = extraordinaryVertices(mesh).size();
        extraordinary * 10 > mesh.n_vertices())
        result.push_back(of(extraordinary, mesh.n_vertices(), "vertices") +
                         (extraordinary == 1 ? "is" : "are") + " extraordinary. A semi-regular mesh has few");
    return result;
}

} // namespace qm
