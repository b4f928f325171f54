#include "bspline/network/vertex_rules.h"

#include "base/at.h"

#include <cmath>
#include <cstddef>

namespace qm {
namespace {

using Pair = std::array<HalfedgeId, 2>;

/// Cosine of the angle by which a path turns that arrives over one halfedge's edge and leaves over the
/// other's; -1 where an edge has no length.
double straightness(const QuadMesh& mesh, const Pair& pair) {
    const Point a = mesh.calc_edge_vector(pair[0]);
    const Point b = mesh.calc_edge_vector(pair[1]);
    const double lengths = a.norm() * b.norm();
    return lengths > 0 ? -(a | b) / lengths : -1;
}

/// True if one quad fills the angle counter-clockwise from one halfedge to the other.
bool quadAloneBetween(const QuadMesh& mesh, HalfedgeId from, HalfedgeId to) {
    return !mesh.is_boundary(from) && mesh.ccw_rotated_halfedge_handle(from) == to;
}

/// Of a vertex, without the layout.
VertexRule ruleByCreases(const QuadMesh& mesh, const std::vector<bool>& sharp, VertexId vertex) {
    if (mesh.is_isolated(vertex)) return {VertexRule::Kind::corner};
    Pair found;
    std::size_t count = 0;
    for (const HalfedgeId halfedge : mesh.voh_range(vertex))
        if (sharp[at(mesh.edge_handle(halfedge))]) {
            if (count < 2) found[count] = halfedge;
            ++count;
        }
    if (count == 0) return {};
    if (count == 1) return {VertexRule::Kind::dart, {found[0], found[0]}};
    return count == 2 && isCurve(mesh, found) ? VertexRule{VertexRule::Kind::crease, found}
                                              : VertexRule{VertexRule::Kind::corner};
}

} // namespace

bool isCurve(const QuadMesh& mesh, const std::array<HalfedgeId, 2>& creases) {
    return !quadAloneBetween(mesh, creases[0], creases[1]) &&
           !quadAloneBetween(mesh, creases[1], creases[0]) &&
           straightness(mesh, creases) >= std::cos(cornerAngle);
}

bool isRegularCrease(const QuadMesh& mesh, VertexId vertex, const VertexRule& rule) {
    if (rule.kind != VertexRule::Kind::crease) return false;
    if (mesh.is_boundary(vertex)) return mesh.valence(vertex) == 3;
    const HalfedgeId next = mesh.ccw_rotated_halfedge_handle(rule.along[0]);
    return mesh.valence(vertex) == 4 && mesh.ccw_rotated_halfedge_handle(next) == rule.along[1];
}

std::vector<VertexRule> vertexRules(const QuadMesh& mesh, const Layout& layout,
                                    const std::vector<bool>& sharp) {
    std::vector<VertexRule> rules(mesh.n_vertices());
    for (const VertexId vertex : mesh.vertices())
        rules[at(vertex)] = ruleByCreases(mesh, sharp, vertex);
    std::vector<bool> isPassed(mesh.n_vertices());
    for (const Segment& segment : layout.segments)
        for (const std::vector<VertexId>& side : segment.sides)
            for (std::size_t k = 1; k + 1 < side.size(); ++k) {
                const Pair pair{mesh.find_halfedge(side[k], side[k - 1]),
                                mesh.find_halfedge(side[k], side[k + 1])};
                if (!sharp[at(mesh.edge_handle(pair[0]))] || !sharp[at(mesh.edge_handle(pair[1]))]) continue;
                VertexRule& rule = rules[at(side[k])];
                if (isPassed[at(side[k])] && straightness(mesh, pair) <= straightness(mesh, rule.along))
                    continue;
                rule = {VertexRule::Kind::crease, pair};
                isPassed[at(side[k])] = true;
            }
    return rules;
}

} // namespace qm
