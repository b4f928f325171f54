#include "document/sections/mesh_paths.h"

#include "base/at.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

namespace qm {

namespace {

/// Walks around both ends in step, so that a vertex with very many edges costs no more than its neighbour.
HalfedgeId halfedgeBetween(const QuadMesh& mesh, VertexId from, VertexId to) {
    auto forth = mesh.cvoh_iter(from);
    auto back = mesh.cvoh_iter(to);
    for (; forth.is_valid() && back.is_valid(); ++forth, ++back) {
        if (mesh.to_vertex_handle(*forth) == to) return *forth;
        if (mesh.to_vertex_handle(*back) == from) return mesh.opposite_halfedge_handle(*back);
    }
    return HalfedgeId();
}

std::string text(VertexId vertex) {
    return std::to_string(vertex.idx());
}

std::vector<VertexId> verticesAt(const QuadMesh& mesh, const JsonPlace& place) {
    std::vector<VertexId> vertices;
    vertices.reserve(place.size());
    for (const int vertex : place.indices(mesh.n_vertices(), "vertex"))
        vertices.emplace_back(vertex);
    return vertices;
}

} // namespace

VertexId vertexAt(const QuadMesh& mesh, const JsonPlace& place) {
    return VertexId(place.index(mesh.n_vertices(), "vertex"));
}

std::optional<VertexId> vertexOrNullAt(const QuadMesh& mesh, const JsonPlace& place) {
    if (place.isNull()) return {};
    return vertexAt(mesh, place);
}

std::vector<HalfedgeId> pathAt(const QuadMesh& mesh, const JsonPlace& place) {
    const std::vector<VertexId> vertices = verticesAt(mesh, place);
    if (vertices.size() < 2) place.fail("a path has at least two vertices");
    std::vector<HalfedgeId> path;
    path.reserve(vertices.size() - 1);
    for (std::size_t i = 1; i < vertices.size(); ++i) {
        path.push_back(halfedgeBetween(mesh, vertices[i - 1], vertices[i]));
        if (!path.back().is_valid())
            place.failAt(i, "vertex " + text(vertices[i]) + " is not joined to vertex " +
                                text(vertices[i - 1]) + " by an edge");
    }
    return path;
}

void requireStraight(const QuadMesh& mesh, const std::vector<HalfedgeId>& path, const JsonPlace& place) {
    for (std::size_t i = 1; i < path.size(); ++i) {
        const VertexId vertex = mesh.from_vertex_handle(path[i]);
        if (mesh.is_boundary(vertex))
            place.failAt(i, "vertex " + text(vertex) + " is on the boundary, where lines end");
        if (!isRegular(mesh, vertex))
            place.failAt(i, "vertex " + text(vertex) + " is extraordinary, where lines end");
        if (straightOn(mesh, path[i - 1]) != path[i])
            place.failAt(i, "the path turns at vertex " + text(vertex),
                         "Straight on lies vertex " +
                             text(mesh.to_vertex_handle(straightOn(mesh, path[i - 1]))));
    }
}

Json numberOf(const std::optional<VertexId>& vertex) {
    return vertex ? Json(vertex->idx()) : Json();
}

Json pathNumbers(const QuadMesh& mesh, std::span<const HalfedgeId> path) {
    return numbersOf(verticesAlong(mesh, path));
}

bool sameCost(double a, double b) {
    constexpr double share = 1e-6; // other programs write six or seven digits
    return std::abs(a - b) <= share * std::max(1.0, std::abs(a));
}

void verifyCost(const JsonPlace& entry, const std::optional<double>& cost) {
    const std::optional<JsonPlace> given = entry.find("cost");
    if (!given) return;
    const std::optional<double> number = given->numberOrNull();
    if (number.has_value() != cost.has_value() || (cost && !sameCost(*cost, *number)))
        given->fail("is not " + (cost ? std::to_string(*cost) + ", the sum over the edges" : "null"),
                    "Leave the cost out and it is added up anew");
}

void verifyDistinctIds(const JsonPlace& list) {
    std::unordered_set<std::int64_t> known;
    for (const JsonPlace& entry : list.elements()) {
        const JsonPlace id = entry["id"];
        const std::int64_t number = id.whole(0);
        if (!known.insert(number).second) id.fail("another entry has id " + std::to_string(number) + " too");
    }
}

void verifyPositionId(const JsonPlace& entry, std::size_t index) {
    if (std::cmp_not_equal(entry["id"].whole(), index))
        entry["id"].fail("is not the entry's position in its list, " + std::to_string(index));
}

} // namespace qm
