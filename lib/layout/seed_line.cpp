#include "layout/seed_line.h"

#include "base/at.h"
#include "mesh/mesh_lines.h"

#include <algorithm>

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
    const MeshLine ahead = straightFrom(mesh, start);
    if (ahead.closed) return ahead.halfedges;
    std::vector<HalfedgeId> line = straightFrom(mesh, mesh.opposite_halfedge_handle(start)).halfedges;
    std::ranges::reverse(line);
    for (HalfedgeId& halfedge : line)
        halfedge = mesh.opposite_halfedge_handle(halfedge);
    line.insert(line.end(), ahead.halfedges.begin() + 1, ahead.halfedges.end());
    return line;
}

} // namespace qm
