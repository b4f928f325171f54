#include "bspline/corner_directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

/// Moves angles until each is at least and at most so much larger than the one before.
std::vector<double> spaced(std::vector<double> angles, double least, double most) {
    const std::size_t size = angles.size();
    for (int round = 0; round < 100; ++round) {
        bool good = true;
        for (std::size_t k = 0; k < size; ++k) {
            const std::size_t next = (k + 1) % size;
            const double turn = next == 0 ? 2 * std::numbers::pi : 0;
            const double between = angles[next] + turn - angles[k];
            const double missing = between < least ? least - between : std::min(most - between, 0.0);
            if (std::abs(missing) <= 1e-3) continue;
            angles[k] -= missing / 2;
            angles[next] += missing / 2;
            good = false;
        }
        if (good) break;
    }
    return angles;
}

} // namespace

CornerDirections::CornerDirections(const QuadMesh& mesh, const Chains& chains, const LineDerivatives& lines)
    : directions_(mesh.n_halfedges(), Point(0, 0, 0)) {
    std::vector<bool> done(mesh.n_vertices(), false);
    // Where a chain passes, its direction is settled.
    for (const BorderChain& chain : chains.all())
        for (std::size_t k = 1; k < chain.halfedges.size(); ++k)
            done[static_cast<std::size_t>(mesh.from_vertex_handle(chain.halfedges[k]).idx())] = true;
    const auto visit = [&](HalfedgeId first) {
        const VertexId vertex = mesh.from_vertex_handle(first);
        if (done[static_cast<std::size_t>(vertex.idx())]) return;
        done[static_cast<std::size_t>(vertex.idx())] = true;
        std::vector<HalfedgeId> around;
        HalfedgeId halfedge = first;
        do {
            if (mesh.is_boundary(halfedge) || !lines.isSmooth(mesh.edge_handle(halfedge))) return;
            if (chains.isBorder(mesh.edge_handle(halfedge))) around.push_back(halfedge);
            halfedge = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(halfedge));
        } while (halfedge != first);
        const Point normal = lines.normalOnLeft(first);
        if (around.size() > 2 && normal.sqrnorm() > 0) spread(mesh, around, normal);
    };
    for (const BorderChain& chain : chains.all()) {
        visit(chain.halfedges.front());
        visit(mesh.opposite_halfedge_handle(chain.halfedges.back()));
    }
}

void CornerDirections::spread(const QuadMesh& mesh, const std::vector<HalfedgeId>& around,
                              const Point& normal) {
    constexpr double leastAngle = 0.6;
    constexpr double mostAngle = 2.5;
    const auto step = [&](HalfedgeId halfedge) -> Point {
        const Point edge =
            mesh.point(mesh.to_vertex_handle(halfedge)) - mesh.point(mesh.from_vertex_handle(halfedge));
        return edge - (edge | normal) * normal;
    };
    const Point first = step(around.front());
    const double length = first.norm();
    if (!(length > 0)) return;
    const Point x = first / length;
    const Point y = normal % x;
    const double least = std::min(leastAngle, std::numbers::pi / static_cast<double>(around.size()));
    std::vector<double> angles;
    for (const HalfedgeId halfedge : around) {
        const Point edge = step(halfedge);
        double angle = std::atan2(edge | y, edge | x);
        // From one border to the next, whether in order or somewhat behind, it is less than a turn.
        if (!angles.empty()) {
            while (angle < angles.back() - std::numbers::pi / 4)
                angle += 2 * std::numbers::pi;
        }
        angles.push_back(angle);
    }
    if (angles.back() > 2 * std::numbers::pi + std::numbers::pi / 4) return; // more than one turn: no order
    const auto spreadAngles = spaced(angles, least, mostAngle);
    for (std::size_t k = 0; k < around.size(); ++k)
        if (spreadAngles[k] != angles[k])
            directions_[static_cast<std::size_t>(around[k].idx())] =
                std::cos(spreadAngles[k]) * x + std::sin(spreadAngles[k]) * y;
}

Point CornerDirections::operator[](HalfedgeId halfedge) const {
    return directions_[static_cast<std::size_t>(halfedge.idx())];
}

} // namespace qm
