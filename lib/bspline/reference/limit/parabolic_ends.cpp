#include "bspline/reference/limit/parabolic_ends.h"

#include "base/at.h"
#include "bspline/splines/evaluate.h"
#include "mesh/topology.h"

#include <cstddef>
#include <utility>

namespace qm {
namespace {

/// Turns decrease to 27 per cent from vertex to vertex, so those after as many edges are negligible.
constexpr std::size_t maxEdges = 8;

/// A derivative changes by this share of itself at most: by 27 degrees if it only turns.
constexpr double maxShare = 0.5;

class ParabolicEnds {
public:
    ParabolicEnds(const MeshLattice& lattice, const Sharpness& sharpness)
        : lattice_(lattice), mesh_(lattice.numbers().mesh()), sharpness_(sharpness) {}

    [[nodiscard]] std::vector<Turn> run() {
        for (const HalfedgeId leaving : mesh_.halfedges())
            if (isEnd(leaving)) turnLine(leaving);
        return std::move(turns_);
    }

private:
    [[nodiscard]] bool isSharp(HalfedgeId halfedge) const {
        return sharpness_.edges[at(mesh_.edge_handle(halfedge))];
    }

    /// Whether a line begins with a halfedge, and can be turned alone: a mesh line between two creases, or a
    /// crease with single quads on both sides.
    [[nodiscard]] bool isEnd(HalfedgeId leaving) const {
        const VertexRule& rule = sharpness_.rules[at(mesh_.from_vertex_handle(leaving))];
        if (rule.kind == VertexRule::Kind::smooth || rule.kind == VertexRule::Kind::dart) return false;
        if (rule.onward(leaving).is_valid()) return false;
        return isSharp(mesh_.cw_rotated_halfedge_handle(leaving)) &&
               isSharp(mesh_.ccw_rotated_halfedge_handle(leaving));
    }

    /// The halfedge with which a line goes on after one, or an invalid one.
    [[nodiscard]] HalfedgeId after(HalfedgeId halfedge) const {
        const VertexId vertex = mesh_.to_vertex_handle(halfedge);
        const VertexRule& rule = sharpness_.rules[at(vertex)];
        if (!isSharp(halfedge))
            return rule.kind == VertexRule::Kind::smooth && continuesStraight(mesh_, vertex)
                       ? straightOn(mesh_, halfedge)
                       : HalfedgeId();
        if (!isRegularCrease(mesh_, vertex, rule)) return HalfedgeId();
        return rule.onward(mesh_.opposite_halfedge_handle(halfedge));
    }

    /// The first edges of a line.
    [[nodiscard]] std::vector<HalfedgeId> lineFrom(HalfedgeId first) const {
        std::vector<HalfedgeId> line{first};
        for (HalfedgeId next = after(first); next.is_valid() && line.size() < maxEdges; next = after(next))
            line.push_back(next);
        return line;
    }

    /// Turns s_k at the vertices of a line that begins at vertex 0, with s_0 + s_1 as large as a parabola
    /// lacks, and s_{k-1} + 4 s_k + s_{k+1} = 0 between, which keeps second derivatives continuous.
    void turnLine(HalfedgeId first) {
        const std::vector<HalfedgeId> line = lineFrom(first);
        const HalfedgeId last = mesh_.opposite_halfedge_handle(line.back());
        const bool endsToo = line.size() < maxEdges && isEnd(last);
        if (endsToo && line.size() == 1) return; // straight
        // s_k = -ratio[k] s_{k-1}; what happens at the other end is that end's own concern.
        std::vector<double> ratio(line.size() + 1, endsToo ? 1 : 0);
        for (std::size_t k = line.size() - 1; k > 0; --k)
            ratio[k] = 1 / (4 - ratio[k + 1]);
        const Point chord = unit(mesh_.calc_edge_vector(first));
        const Point lacking = 2 * chord - unit(lattice_.derivative(first)) +
                              unit(lattice_.derivative(mesh_.opposite_halfedge_handle(first)));
        Point turn = lacking / (1 - ratio[1]);
        if (turn.norm() > maxShare) turn *= maxShare / turn.norm();
        add(first, turn);
        for (std::size_t k = 1; k <= line.size() && ratio[k] > 0; ++k) {
            turn *= -ratio[k];
            add(mesh_.opposite_halfedge_handle(line[k - 1]), -turn);
            if (k < line.size()) add(line[k], turn);
        }
    }

    /// \param by  relative to the length of the derivative
    void add(HalfedgeId leaving, Point by) {
        const Point derivative = lattice_.derivative(leaving);
        if (!isSharp(leaving)) {
            const Point beside = lattice_.derivative(mesh_.ccw_rotated_halfedge_handle(leaving));
            const Point normal = unit(derivative % beside);
            by = normal * (normal | by);
        }
        turns_.push_back({leaving, derivative.norm() * by});
    }

    const MeshLattice& lattice_;
    const QuadMesh& mesh_;
    Sharpness sharpness_;
    std::vector<Turn> turns_;
};

} // namespace

std::vector<Turn> parabolicEnds(const MeshLattice& lattice, const Sharpness& sharpness) {
    return ParabolicEnds(lattice, sharpness).run();
}

} // namespace qm
