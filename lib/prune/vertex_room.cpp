#include "prune/vertex_room.h"

#include "prune/border_angles.h"

#include <cmath>
#include <utility>

namespace qm {
namespace {

/// \param total  sum of the angles of all faces, degrees
std::size_t maxMissing(std::size_t faces, double total, double minCorner) {
    constexpr double halfTurn = 180;
    constexpr double maxTurn = 90;
    std::size_t missing = 0;
    for (std::size_t passing = 1; 2 * passing <= faces; ++passing) {
        const std::size_t corners = faces - 2 * passing;
        const double rest = total - static_cast<double>(passing) * halfTurn;
        // Without corners, the remaining angle is that by which the one side turns.
        const double angle = corners > 0 ? rest / static_cast<double>(corners) : std::abs(rest);
        if (corners > 0 ? angle < minCorner || angle > halfTurn - minCorner : angle > maxTurn) break;
        missing = passing;
    }
    return missing;
}

} // namespace

std::vector<RoomSector> roomAt(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                               VertexId vertex, double minCorner) {
    const auto leaving = mesh.voh_ccw_range(vertex);
    const std::vector<HalfedgeId> edges(leaving.begin(), leaving.end());
    const std::size_t count = edges.size();
    if (minCorner <= 0) return {{edges, count}};
    std::vector<std::size_t> ends;
    for (std::size_t k = 0; k < count; ++k)
        if (isSharp(mesh, dihedralAngles, edges[k])) ends.push_back(k);
    if (ends.size() < 2) return {{edges, maxMissing(count, 360, minCorner)}};
    const auto edgeAt = [&](std::size_t k) { return edges[k < count ? k : k - count]; };
    std::vector<RoomSector> sectors;
    for (std::size_t s = 0; s < ends.size(); ++s) {
        const std::size_t end = s + 1 < ends.size() ? ends[s + 1] : ends.front() + count;
        if (mesh.is_boundary(edges[ends[s]])) continue; // there are no faces beyond it
        RoomSector sector;
        double total = 0;
        for (std::size_t k = ends[s]; k < end; ++k) {
            if (k > ends[s]) sector.edges.push_back(edgeAt(k));
            total += 180 - turnBetween(mesh, edgeAt(k), edgeAt(k + 1));
        }
        if (sector.edges.empty()) continue;
        sector.maxMissing = maxMissing(sector.edges.size() + 1, total, minCorner);
        sectors.push_back(std::move(sector));
    }
    return sectors;
}

} // namespace qm
