#include "mesh/roundness.h"

#include "mesh/quad_geometry.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

/// Lines that bend by more in the mean, in radians, are sharp: eight quads around may be a cylinder, fewer
/// are a prism.
constexpr double maxMean = 0.8;
/// Single edges may bend by more, as meshes are uneven, but not by more than this.
constexpr double maxSingle = 1.2;

/// The rotation from the normal on the left of a halfedge to that on its right: its axis, as long as the
/// angle in radians. Zero on the boundary and beside faces without a normal.
Point rotation(const QuadMesh& mesh, HalfedgeId halfedge) {
    const Point none{0, 0, 0};
    if (mesh.is_boundary(mesh.edge_handle(halfedge))) return none;
    const auto left = quadNormal(mesh, mesh.face_handle(halfedge));
    const auto right = quadNormal(mesh, mesh.opposite_face_handle(halfedge));
    if (!left || !right) return none;
    const Point axis = *left % *right;
    const double length = axis.norm();
    return length > 0 ? axis * (std::atan2(length, *left | *right) / length) : none;
}

} // namespace

double roundness(const QuadMesh& mesh, const std::vector<HalfedgeId>& line) {
    double bend = 0;
    double beside = 0;
    for (const HalfedgeId edge : line) {
        const Point here = rotation(mesh, edge);
        const double angle = here.norm();
        if (angle > maxSingle) return 0;
        if (!(angle > 0)) continue;
        const HalfedgeId back = mesh.opposite_halfedge_handle(edge);
        const Point left = rotation(mesh, acrossQuad(mesh, edge));
        const Point right = -rotation(mesh, acrossQuad(mesh, back));
        bend += angle;
        beside += std::max(0.0, std::min(left | here, right | here) / angle);
    }
    const bool isSharp = !(bend > 0) || bend > maxMean * static_cast<double>(line.size());
    return isSharp ? 0 : std::min(1.0, beside / bend);
}

} // namespace qm
