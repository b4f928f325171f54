#include "prune/grid_program.h"

#include "mesh/topology.h"
#include "prune/turn.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace qm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

class Builder {
public:
    Builder(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
            const std::vector<double>& arcCosts, double maxTurn)
        : mesh_(mesh), complex_(complex), graph_(graph), maxTurn_(maxTurn), arcOf_(mesh.n_edges()) {
        result_.program.costs = arcCosts;
        result_.quarters.assign(arcCosts.size(), 0);
        for (std::size_t arc = 0; arc < graph.arcs.size(); ++arc)
            for (const HalfedgeId halfedge : halfedgesOf(graph, complex, ArcId(arc)))
                arcOf_[at(mesh.edge_handle(halfedge).idx())] = ArcId(arc);
    }

    GridProgram build(const Layout& layout) {
        for (const Junction& junction : graph_.junctions)
            addJunction(junction);
        for (const VertexId vertex : complex_.extraordinaryVertices)
            addExtraordinary(vertex);
        for (const VertexId vertex : mesh_.vertices())
            if (mesh_.is_boundary(vertex) && !mesh_.is_isolated(vertex) && isRegular(mesh_, vertex))
                addBoundary(vertex);
        for (const LayoutTrack& track : layout.tracks)
            if (!track.transversal) {
                keepSmooth(track.track.halfedges.back());
                keepSmooth(mesh_.opposite_halfedge_handle(track.track.halfedges.front()));
            }
        return std::move(result_);
    }

private:
    using Terms = std::vector<std::pair<ArcId, double>>;

    /// Sum of the terms >= lower; arcs that are invalid are out.
    void atLeast(const Terms& terms, double lower) {
        IntegerProgram::Row row{{}, {}, lower, infinity};
        for (const auto& [arc, weight] : terms)
            if (arc.valid()) row.add(arc.value(), weight);
        result_.program.rows.push_back(std::move(row));
    }

    void addJunction(const Junction& junction) {
        const auto& arcs = junction.arcs;
        for (const std::size_t k : {0U, 1U, 2U, 3U})
            for (const std::size_t wall : {1U, 3U}) // arc k ends here only at a wall
                if (arcs[k].valid() && arcs[k] != arcs[(k + 2) % 4])
                    atLeast({{arcs[(k + 2) % 4], 1}, {arcs[(k + wall) % 4], 1}, {arcs[k], -1}}, 0);
        addCorners(junction);
    }

    /// A T has two corners and a + four: two for every arc, less four if there are any.
    void addCorners(const Junction& junction) {
        const int touched = static_cast<int>(result_.program.costs.size());
        result_.program.costs.push_back(0);
        result_.quarters.push_back(-4);
        IntegerProgram::Row row{{touched}, {-2}, 0, infinity};
        for (const ArcId arc : junction.arcs)
            if (arc.valid()) {
                result_.quarters[arc.idx()] += 2;
                row.add(arc.value(), 1);
            }
        result_.program.rows.push_back(std::move(row));
    }

    ArcId arcAt(HalfedgeId leaving) const { return arcOf_[at(mesh_.edge_handle(leaving).idx())]; }
    bool isBoundary(HalfedgeId halfedge) const { return mesh_.is_boundary(mesh_.edge_handle(halfedge)); }

    /// Edges in clockwise order, from boundary to boundary or all around.
    std::vector<HalfedgeId> edgesAround(VertexId vertex) const {
        std::vector<HalfedgeId> edges;
        for (const HalfedgeId halfedge : mesh_.voh_range(vertex))
            edges.push_back(halfedge);
        return edges;
    }

    /// One of two neighbours is in; where both are, there is a corner.
    void addExtraordinary(VertexId vertex) {
        const std::vector<HalfedgeId> edges = edgesAround(vertex);
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const HalfedgeId edge = edges[k], next = edges[(k + 1) % edges.size()],
                             afterNext = edges[(k + 2) % edges.size()];
            if (!haveQuadBetween(edge, next)) continue;
            const ArcId a = arcAt(edge), b = arcAt(next);
            const double known = (isBoundary(edge) ? 1 : 0) + (isBoundary(next) ? 1 : 0);
            if (known == 0) atLeast({{a, 1}, {b, 1}}, 1);
            for (const ArcId arc : {a, b})
                if (arc.valid()) result_.quarters[arc.idx()] += 1;
            result_.corners += known - 1;
            const bool mayEnd = !isBoundary(next) && b.valid() && haveQuadBetween(next, afterNext);
            if (mayEnd && turnBetween(mesh_, edge, afterNext) > maxTurn_) atLeast({{b, 1}}, 1);
        }
    }

    bool haveQuadBetween(HalfedgeId edge, HalfedgeId next) const {
        return mesh_.ccw_rotated_halfedge_handle(next) == edge ? !mesh_.is_boundary(next)
                                                               : !mesh_.is_boundary(edge);
    }

    /// A corner of the mesh, or two where a track ends.
    void addBoundary(VertexId vertex) {
        if (mesh_.valence(vertex) == 2) result_.corners += 1;
        for (const HalfedgeId halfedge : mesh_.voh_range(vertex))
            if (arcAt(halfedge).valid()) result_.quarters[arcAt(halfedge).idx()] += 2;
    }

    /// A track of the layout that ends where others turn by too much stays as long as these pass.
    void keepSmooth(HalfedgeId arriving) {
        const VertexId vertex = mesh_.to_vertex_handle(arriving);
        if (!continuesStraight(mesh_, vertex)) return;
        const HalfedgeId left = mesh_.next_halfedge_handle(arriving);
        const HalfedgeId right = mesh_.opposite_halfedge_handle(
            mesh_.prev_halfedge_handle(mesh_.opposite_halfedge_handle(arriving)));
        if (!arcAt(arriving).valid() || !arcAt(left).valid() || !arcAt(right).valid()) return;
        if (turnBetween(mesh_, left, right) > maxTurn_)
            atLeast({{arcAt(arriving), 1}, {arcAt(left), -1}, {arcAt(right), -1}}, -1);
    }

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    const ArcGraph& graph_;
    double maxTurn_;
    std::vector<ArcId> arcOf_; ///< of every edge
    GridProgram result_;
};

} // namespace

double GridProgram::segments(const std::vector<double>& values) const {
    double sum = corners;
    for (std::size_t column = 0; column < values.size(); ++column)
        sum += quarters[column] * values[column];
    return sum / 4;
}

GridProgram gridProgram(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
                        const std::vector<double>& arcCosts, const Layout& layout, double maxTurn) {
    return Builder(mesh, complex, graph, arcCosts, maxTurn).build(layout);
}

} // namespace qm
