#include "prune/grid_program.h"

#include "base/at.h"
#include "base/infinity.h"
#include "mesh/topology.h"
#include "prune/cornerless_segments.h"
#include "prune/smoothness_rows.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace qm {
namespace {

/// The rows that keep segments grids, and the corners that these have.
class Builder {
public:
    Builder(const QuadMesh& mesh, const BaseComplex& complex, GridProgram& result)
        : mesh_(mesh), complex_(complex), result_(result) {}

    /// \param smoothness  adds its rows at extraordinary vertices
    void build(SmoothnessRows& smoothness) {
        for (const Junction& junction : result_.graph.junctions)
            addJunction(junction);
        for (const Seed seed : complex_.seeds)
            addSeed(seed);
        for (const VertexId vertex : complex_.extraordinaryVertices) {
            addExtraordinary(vertex, smoothness);
            smoothness.keepRoom(vertex);
        }
        for (const VertexId vertex : mesh_.vertices())
            if (mesh_.is_boundary(vertex) && !mesh_.is_isolated(vertex) && isRegular(mesh_, vertex))
                addBoundary(vertex);
    }

    /// An arc is in if an edge of it is required, and out if one is forbidden.
    void addDemands(const Constraints& constraints) {
        for (const EdgeId edge : constraints.required)
            if (result_.arcOf[at(edge)].valid()) result_.addRow({{result_.arcOf[at(edge)], 1}}, 1);
        for (const EdgeId edge : constraints.forbidden)
            if (result_.arcOf[at(edge)].valid()) result_.addRow({{result_.arcOf[at(edge)], -1}}, 0);
    }

private:
    static ColumnId columnOf(ArcId arc) { return GridProgram::columnOf(arc); }

    void addJunction(const Junction& junction) {
        const auto& arcs = junction.arcs;
        for (const std::size_t k : {0U, 1U, 2U, 3U})
            for (const std::size_t wall : {1U, 3U}) // arc k ends here only at a wall
                if (arcs[k].valid() && arcs[k] != arcs[(k + 2) % 4])
                    result_.addRow({{arcs[(k + 2) % 4], 1}, {arcs[(k + wall) % 4], 1}, {arcs[k], -1}}, 0);
        addCorners(junction);
    }

    /// A T has two corners and a + four: two for every arc, less four if there are any.
    void addCorners(const Junction& junction) {
        std::vector<ArcId> arcs;
        std::ranges::copy_if(junction.arcs, std::back_inserter(arcs), &ArcId::valid);
        IntegerProgram::Row row{
            {result_.addIndicator({arcs, GridProgram::Indicator::OneIf::anyIsIn}, -4)}, {-2}, 0, infinity};
        for (const ArcId arc : arcs) {
            result_.quarters[columnOf(arc)] += 2;
            row.add(columnOf(arc), 1);
        }
        result_.program.rows.push_back(std::move(row));
    }

    /// Where no line crosses a seed's there is no junction, but the line goes on all the same.
    void addSeed(Seed seed) {
        if (hasJunction(mesh_.from_vertex_handle(seed.direction))) return;
        const ArcId ahead = arcAt(seed.direction),
                    behind = arcAt(straightOn(mesh_, mesh_.opposite_halfedge_handle(seed.direction)));
        if (ahead == behind) return;
        result_.program.rows.push_back({{columnOf(ahead), columnOf(behind)}, {1, -1}, 0, 0});
    }

    bool hasJunction(VertexId vertex) const {
        return std::ranges::binary_search(result_.graph.junctions, vertex.idx(), {},
                                          [](const Junction& junction) { return junction.vertex.idx(); });
    }

    ArcId arcAt(HalfedgeId leaving) const { return result_.arcOf[at(mesh_.edge_handle(leaving))]; }
    bool isBoundary(HalfedgeId halfedge) const { return mesh_.is_boundary(mesh_.edge_handle(halfedge)); }

    /// One of two neighbours is in; where both are, there is a corner.
    void addExtraordinary(VertexId vertex, const SmoothnessRows& smoothness) {
        const auto clockwise = mesh_.voh_range(vertex); // from boundary to boundary or all around
        const std::vector<HalfedgeId> edges(clockwise.begin(), clockwise.end());
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const HalfedgeId edge = edges[k], next = edges[(k + 1) % edges.size()],
                             afterNext = edges[(k + 2) % edges.size()];
            if (!haveQuadBetween(edge, next)) continue;
            const ArcId a = arcAt(edge), b = arcAt(next);
            const double known = (isBoundary(edge) ? 1 : 0) + (isBoundary(next) ? 1 : 0);
            if (known == 0) result_.addRow({{a, 1}, {b, 1}}, 1);
            for (const ArcId arc : {a, b})
                if (arc.valid()) result_.quarters[columnOf(arc)] += 1;
            result_.corners += known - 1;
            if (haveQuadBetween(next, afterNext) && smoothness.mustStay(edge, next, afterNext))
                result_.addRow({{b, 1}}, 1);
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
            if (arcAt(halfedge).valid()) result_.quarters[columnOf(arcAt(halfedge))] += 2;
    }

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    GridProgram& result_;
};

} // namespace

double GridProgram::segments(const ColumnValues& values) const {
    double sum = corners;
    for (const ColumnId column : values.ids())
        sum += quarters[column] * values[column];
    return sum / 4;
}

void GridProgram::addRow(const Terms& terms, double lower) {
    IntegerProgram::Row row{{}, {}, lower, infinity};
    for (const auto& [arc, weight] : terms)
        if (arc.valid()) row.add(columnOf(arc), weight);
    program.rows.push_back(std::move(row));
}

ColumnId GridProgram::addIndicator(Indicator indicator, double addedQuarters, double cost) {
    program.costs.push_back(cost);
    quarters.push_back(addedQuarters);
    indicators.push_back(std::move(indicator));
    return program.costs.nextId() - 1;
}

ColumnValues GridProgram::valuesOf(const PresentArcs& present) const {
    ColumnValues values(present.begin(), present.end());
    for (const Indicator& indicator : indicators) {
        const bool any = std::ranges::any_of(indicator.arcs, [&](ArcId arc) { return present[arc]; });
        values.push_back(any == (indicator.when == Indicator::OneIf::anyIsIn) ? 1 : 0);
    }
    return values;
}

GridProgram gridProgram(const PrunedMesh& pruned, const Layout& layout, const Smoothness& smoothness,
                        const Constraints& constraints) {
    const auto& [mesh, complex, dihedralAngles, edgeCosts] = pruned;
    GridProgram result;
    result.graph = buildArcGraph(mesh, complex);
    result.arcOf = arcsOfEdges(mesh, result.graph, complex);
    result.program.costs = ColumnValues(sumOverArcs(mesh, result.graph, complex, edgeCosts));
    result.quarters.assign(result.graph.arcs.size(), 0);
    SmoothnessRows smoothnessRows(pruned, layout, smoothness, result);
    Builder builder(mesh, complex, result);
    builder.build(smoothnessRows);
    builder.addDemands(constraints);
    addAnnuli(mesh, result);
    addSeedLines(pruned, result);
    smoothnessRows.keepEnds();
    return result;
}

} // namespace qm
