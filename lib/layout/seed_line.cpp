#include "layout/seed_line.h"

#include "base/at.h"
#include "mesh/topology.h"

namespace qm {
namespace {

HalfedgeId edgeOfMaxAngle(const QuadMesh& mesh, std::span<const FaceId> faces,
                          const std::vector<double>& dihedralAngles) {
    EdgeId best;
    const auto angle = [&](EdgeId edge) { return dihedralAngles[at(edge)]; };
    for (const FaceId face : faces)
        for (const EdgeId edge : mesh.fe_range(face)) {
            if (mesh.is_boundary(edge)) continue;
            if (!best.is_valid() || angle(edge) > angle(best) || (angle(edge) == angle(best) && edge < best))
                best = edge;
        }
    return mesh.halfedge_handle(best, 0);
}

} // namespace

std::vector<HalfedgeId> seedLine(const QuadMesh& mesh, std::span<const FaceId> faces,
                                 const std::vector<double>& dihedralAngles) {
    const HalfedgeId start = edgeOfMaxAngle(mesh, faces, dihedralAngles);
    std::vector<HalfedgeId> line{start};
    while (continuesStraight(mesh, mesh.to_vertex_handle(line.back()))) {
        const HalfedgeId next = straightOn(mesh, line.back());
        if (next == start) return line;
        line.push_back(next);
    }
    std::vector<HalfedgeId> back{mesh.opposite_halfedge_handle(start)};
    while (continuesStraight(mesh, mesh.to_vertex_handle(back.back())))
        back.push_back(straightOn(mesh, back.back()));
    std::vector<HalfedgeId> whole;
    for (std::size_t k = back.size(); k-- > 1;)
        whole.push_back(mesh.opposite_halfedge_handle(back[k]));
    whole.insert(whole.end(), line.begin(), line.end());
    return whole;
}

} // namespace qm
