#include "prune/vertex_room.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace qm {
namespace {

/// Radians: edges of larger dihedral angles end a tangent plane.
constexpr double sharp = 0.6;

std::vector<HalfedgeId> edgesAround(const QuadMesh& mesh, VertexId vertex) {
    std::vector<HalfedgeId> edges;
    for (const HalfedgeId halfedge : mesh.voh_ccw_range(vertex))
        edges.push_back(halfedge);
    return edges;
}

/// Radians between an edge and the next, counter-clockwise.
double cornerAngle(const QuadMesh& mesh, HalfedgeId edge, HalfedgeId next) {
    const Point a = mesh.calc_edge_vector(edge);
    const Point b = mesh.calc_edge_vector(next);
    return std::atan2((a % b).norm(), a | b);
}

/// \param total  radians of all faces together
std::size_t maxMissing(std::size_t faces, double total, double minCorner) {
    constexpr double halfTurn = std::numbers::pi;
    const double min = minCorner / 180 * halfTurn;
    std::size_t missing = 0;
    for (std::size_t passing = 1; 2 * passing <= faces; ++passing) {
        const std::size_t corners = faces - 2 * passing;
        const double rest = total - static_cast<double>(passing) * halfTurn;
        // Without corners it is a matter of how far the one side turns.
        const double angle = corners > 0 ? rest / static_cast<double>(corners) : halfTurn / 2;
        if (angle < min || angle > halfTurn - min || rest < -halfTurn / 2) break;
        missing = passing;
    }
    return missing;
}

} // namespace

std::vector<RoomSector> roomAt(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                               VertexId vertex, double minCorner) {
    const std::vector<HalfedgeId> edges = edgesAround(mesh, vertex);
    const std::size_t count = edges.size();
    if (minCorner <= 0) return {{edges, count}};
    std::vector<std::size_t> ends;
    for (std::size_t k = 0; k < count; ++k) {
        const EdgeId edge = mesh.edge_handle(edges[k]);
        if (mesh.is_boundary(edge) || dihedralAngles[static_cast<std::size_t>(edge.idx())] > sharp)
            ends.push_back(k);
    }
    if (ends.size() < 2) return {{edges, maxMissing(count, 2 * std::numbers::pi, minCorner)}};
    const auto edgeAt = [&](std::size_t k) { return edges[k < count ? k : k - count]; };
    std::vector<RoomSector> sectors;
    for (std::size_t s = 0; s < ends.size(); ++s) {
        const std::size_t end = s + 1 < ends.size() ? ends[s + 1] : ends.front() + count;
        if (mesh.is_boundary(edges[ends[s]])) continue; // nothing lies beyond it
        RoomSector sector;
        double total = 0;
        for (std::size_t k = ends[s]; k < end; ++k) {
            if (k > ends[s]) sector.edges.push_back(edgeAt(k));
            total += cornerAngle(mesh, edgeAt(k), edgeAt(k + 1));
        }
        if (sector.edges.empty()) continue;
        sector.maxMissing = maxMissing(sector.edges.size() + 1, total, minCorner);
        sectors.push_back(std::move(sector));
    }
    return sectors;
}

} // namespace qm
