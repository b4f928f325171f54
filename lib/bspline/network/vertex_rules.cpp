#include "bspline/network/vertex_rules.h"

#include "base/at.h"
#include "bspline/network/borders.h"
#include "mesh/topology.h"

#include <algorithm>
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
    return !mesh.is_boundary(from) && mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(from)) == to;
}

class Rules {
public:
    Rules(const QuadMesh& mesh, const std::vector<bool>& sharp)
        : mesh_(mesh), sharp_(sharp), rules_(mesh.n_vertices()) {}

    std::vector<VertexRule> find(const Layout& layout) {
        for (const VertexId vertex : mesh_.vertices())
            rules_[at(vertex)] = byCreases(vertex);
        std::vector<bool> passed(mesh_.n_vertices());
        for (const Segment& segment : layout.segments)
            for (int side = 0; side < 4; ++side)
                passAlong(segment, side, passed);
        return std::move(rules_);
    }

private:
    bool isSharp(HalfedgeId halfedge) const { return sharp_[at(mesh_.edge_handle(halfedge))]; }

    /// The rule without the layout.
    VertexRule byCreases(VertexId vertex) const {
        if (mesh_.is_isolated(vertex)) return {VertexRule::Kind::corner};
        Pair found;
        std::size_t count = 0;
        for (const HalfedgeId halfedge : mesh_.voh_range(vertex))
            if (isSharp(halfedge)) {
                if (count < 2) found[count] = halfedge;
                ++count;
            }
        if (count == 0) return {};
        if (count == 1) return {VertexRule::Kind::dart, {found[0], found[0]}};
        return count == 2 && isCurve(mesh_, found) ? VertexRule{VertexRule::Kind::crease, found}
                                                   : VertexRule{VertexRule::Kind::corner};
    }

    /// Lets the curve follow a side through the vertices inside it.
    void passAlong(const Segment& segment, int side, std::vector<bool>& passed) {
        const std::vector<VertexId>& vertices = segment.sides[at(side)];
        HalfedgeId arriving = mesh_.halfedge_handle(segment.faces[faceBeside(segment, side, 0)]);
        while (mesh_.from_vertex_handle(arriving) != vertices.front())
            arriving = mesh_.next_halfedge_handle(arriving);
        for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
            const HalfedgeId leaving = straightOn(mesh_, arriving);
            const Pair pair{mesh_.opposite_halfedge_handle(arriving), leaving};
            arriving = leaving;
            if (!isSharp(pair[0]) || !isSharp(pair[1])) continue;
            VertexRule& rule = rules_[at(vertices[k])];
            auto before = passed[at(vertices[k])];
            if (before && straightness(mesh_, pair) <= straightness(mesh_, rule.along)) continue;
            rule = {VertexRule::Kind::crease, pair};
            before = true;
        }
    }

    const QuadMesh& mesh_;
    const std::vector<bool>& sharp_;
    std::vector<VertexRule> rules_;
};

} // namespace

bool isCurve(const QuadMesh& mesh, const std::array<HalfedgeId, 2>& creases) {
    return !quadAloneBetween(mesh, creases[0], creases[1]) &&
           !quadAloneBetween(mesh, creases[1], creases[0]) &&
           straightness(mesh, creases) >= std::cos(cornerAngle);
}

std::vector<bool> creasesAndBoundary(const QuadMesh& mesh, const std::vector<bool>& isCrease) {
    std::vector<bool> sharp = isCrease;
    for (const EdgeId edge : mesh.edges())
        if (mesh.is_boundary(edge)) sharp[at(edge)] = true;
    return sharp;
}

std::vector<VertexRule> vertexRules(const QuadMesh& mesh, const Layout& layout,
                                    const std::vector<bool>& sharp) {
    return Rules(mesh, sharp).find(layout);
}

} // namespace qm
