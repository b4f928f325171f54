#include "prune/grid_program.h"

#include "base/at.h"
#include "layout/seed_line.h"
#include "mesh/topology.h"
#include "prune/annuli.h"
#include "prune/turn.h"
#include "prune/vertex_room.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace qm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class Builder {
public:
    Builder(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
            const std::vector<double>& dihedralAngles, const std::vector<double>& edgeCosts,
            const Smoothness& smoothness)
        : mesh_(mesh), complex_(complex), graph_(graph), dihedralAngles_(dihedralAngles),
          edgeCosts_(edgeCosts), smoothness_(smoothness), arcOf_(mesh.n_edges()),
          inLayout_(mesh.n_edges(), false) {
        result_.program.costs = ColumnValues(sumOverArcs(mesh, graph, complex, edgeCosts));
        result_.quarters.assign(graph.arcs.size(), 0);
        for (std::size_t arc = 0; arc < graph.arcs.size(); ++arc)
            for (const HalfedgeId halfedge : halfedgesOf(graph, complex, ArcId(arc)))
                arcOf_[at(mesh.edge_handle(halfedge))] = ArcId(arc);
    }

    GridProgram build(const Layout& layout) {
        for (const LayoutTrack& track : layout.tracks)
            for (const HalfedgeId halfedge : track.track.halfedges)
                inLayout_[at(mesh_.edge_handle(halfedge))] = !track.transversal;
        for (const Junction& junction : graph_.junctions)
            addJunction(junction);
        for (const Seed seed : complex_.seeds)
            addSeed(seed);
        for (const VertexId vertex : complex_.extraordinaryVertices) {
            addExtraordinary(vertex);
            keepRoom(vertex);
        }
        for (const VertexId vertex : mesh_.vertices())
            if (mesh_.is_boundary(vertex) && !mesh_.is_isolated(vertex) && isRegular(mesh_, vertex))
                addBoundary(vertex);
        addAnnuli();
        addSeedLines();
        for (const LayoutTrack& track : layout.tracks)
            if (!track.transversal) {
                keepSmooth(track.track.halfedges.back());
                keepSmooth(mesh_.opposite_halfedge_handle(track.track.halfedges.front()));
            }
        return std::move(result_);
    }

private:
    static ColumnId columnOf(ArcId arc) { return GridProgram::columnOf(arc); }

    using Terms = std::vector<std::pair<ArcId, double>>;

    /// Sum of the terms >= lower; arcs that are invalid are out.
    void atLeast(const Terms& terms, double lower) {
        IntegerProgram::Row row{{}, {}, lower, infinity};
        for (const auto& [arc, weight] : terms)
            if (arc.valid()) row.add(columnOf(arc), weight);
        result_.program.rows.push_back(std::move(row));
    }

    /// \return the new column
    ColumnId addIndicator(std::vector<ArcId> arcs, bool ofAny, double quarters, double cost = 0) {
        result_.program.costs.push_back(cost);
        result_.quarters.push_back(quarters);
        result_.indicators.push_back({std::move(arcs), ofAny});
        return result_.program.costs.nextId() - 1;
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
        std::vector<ArcId> arcs;
        std::ranges::copy_if(junction.arcs, std::back_inserter(arcs), &ArcId::valid);
        IntegerProgram::Row row{{addIndicator(arcs, true, -4)}, {-2}, 0, infinity};
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
        return std::ranges::binary_search(graph_.junctions, vertex.idx(), {},
                                          [](const Junction& junction) { return junction.vertex.idx(); });
    }

    ArcId arcAt(HalfedgeId leaving) const { return arcOf_[at(mesh_.edge_handle(leaving))]; }
    bool isBoundary(HalfedgeId halfedge) const { return mesh_.is_boundary(mesh_.edge_handle(halfedge)); }

    /// One of two neighbours is in; where both are, there is a corner.
    void addExtraordinary(VertexId vertex) {
        const auto clockwise = mesh_.voh_range(vertex); // from boundary to boundary or all around
        const std::vector<HalfedgeId> edges(clockwise.begin(), clockwise.end());
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const HalfedgeId edge = edges[k], next = edges[(k + 1) % edges.size()],
                             afterNext = edges[(k + 2) % edges.size()];
            if (!haveQuadBetween(edge, next)) continue;
            const ArcId a = arcAt(edge), b = arcAt(next);
            const double known = (isBoundary(edge) ? 1 : 0) + (isBoundary(next) ? 1 : 0);
            if (known == 0) atLeast({{a, 1}, {b, 1}}, 1);
            for (const ArcId arc : {a, b})
                if (arc.valid()) result_.quarters[columnOf(arc)] += 1;
            result_.corners += known - 1;
            const bool mayEnd =
                inLayout_[at(mesh_.edge_handle(next))] && b.valid() && haveQuadBetween(next, afterNext);
            if (mayEnd && turnBetween(mesh_, edge, afterNext) > smoothness_.maxTurn) atLeast({{b, 1}}, 1);
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

    void addAnnuli() {
        const AnnulusBands bands = annulusBands(mesh_, arcOf_);
        std::vector<ColumnId> columns;
        for (const std::vector<ArcId>& across : bands.across) {
            columns.push_back(addIndicator(across, false, 4));
            someOf(across, columns.back());
        }
        for (const AnnulusBands::Joint& joint : bands.joints) {
            std::vector<ArcId> arcs = joint.arcs;
            for (const std::size_t band : joint.bands)
                arcs.insert(arcs.end(), bands.across[band].begin(), bands.across[band].end());
            const ColumnId column = addIndicator(std::move(arcs), false, -4);
            for (const std::size_t band : joint.bands)
                result_.program.rows.push_back({{columns[band], column}, {1, -1}, 0, infinity});
            noneOf(joint.arcs, column);
        }
    }

    /// A torus or an annulus without any source gets a line when nothing else is there.
    void addSeedLines() {
        const Components parts = components(mesh_);
        std::vector<bool> ring(at(parts.count), true);
        for (const VertexId vertex : mesh_.vertices())
            if (!isRegular(mesh_, vertex) || mesh_.is_isolated(vertex) || mesh_.valence(vertex) == 2)
                ring[at(parts.ofVertex[at(vertex)])] = false;
        const auto partOf = [&](HalfedgeId halfedge) {
            return at(parts.ofVertex[at(mesh_.to_vertex_handle(halfedge))]);
        };
        std::vector<std::vector<FaceId>> faces(ring.size());
        std::vector<std::vector<ArcId>> arcs(ring.size());
        for (const FaceId face : mesh_.faces())
            faces[partOf(mesh_.halfedge_handle(face))].push_back(face);
        for (std::size_t arc = 0; arc < graph_.arcs.size(); ++arc)
            arcs[partOf(halfedgesOf(graph_, complex_, ArcId(arc)).front())].emplace_back(arc);
        for (std::size_t part = 0; part < ring.size(); ++part)
            if (ring[part]) addSeedLine(faces[part], arcs[part]);
    }

    void addSeedLine(const std::vector<FaceId>& faces, const std::vector<ArcId>& arcs) {
        double cost = 0;
        const std::vector<HalfedgeId> line = seedLine(mesh_, faces, dihedralAngles_);
        for (const HalfedgeId halfedge : line)
            cost += edgeCosts_[at(mesh_.edge_handle(halfedge))];
        // A loop makes an annulus of a torus, or two of one; a line from border to border a grid of one.
        const bool loop = !mesh_.is_boundary(mesh_.from_vertex_handle(line.front()));
        const ColumnId column = addIndicator(arcs, false, loop ? 4 : 0, cost);
        someOf(arcs, column);
        noneOf(arcs, column);
    }

    /// The column is 1 unless an arc is in.
    void someOf(const std::vector<ArcId>& arcs, ColumnId column) {
        IntegerProgram::Row row{{column}, {1}, 1, infinity};
        for (const ArcId arc : arcs)
            row.columns.push_back(columnOf(arc));
        row.weights.resize(row.columns.size(), 1);
        result_.program.rows.push_back(std::move(row));
    }

    /// The column is 0 if an arc is in.
    void noneOf(const std::vector<ArcId>& arcs, ColumnId column) {
        for (const ArcId arc : arcs)
            result_.program.rows.push_back({{column, columnOf(arc)}, {1, 1}, 0, 1});
    }

    /// Corners keep their room, but where the layout has left them less.
    void keepRoom(VertexId vertex) {
        for (const RoomSector& sector : roomAt(mesh_, dihedralAngles_, vertex, smoothness_.minCorner)) {
            Terms terms;
            std::size_t missing = 0;
            for (const HalfedgeId edge : sector.edges) {
                terms.emplace_back(arcAt(edge), 1);
                missing += inLayout_[at(mesh_.edge_handle(edge))] ? 0 : 1;
            }
            missing = std::max(missing, sector.maxMissing);
            if (missing < terms.size()) atLeast(terms, static_cast<double>(terms.size() - missing));
        }
    }

    /// Where a track of the layout ends at others that turn there, it stays as long as these pass.
    void keepSmooth(HalfedgeId arriving) {
        const VertexId vertex = mesh_.to_vertex_handle(arriving);
        if (!continuesStraight(mesh_, vertex)) return;
        const HalfedgeId left = mesh_.next_halfedge_handle(arriving);
        const HalfedgeId right = mesh_.opposite_halfedge_handle(
            mesh_.prev_halfedge_handle(mesh_.opposite_halfedge_handle(arriving)));
        if (!arcAt(arriving).valid() || !arcAt(left).valid() || !arcAt(right).valid()) return;
        if (turnBetween(mesh_, left, right) > smoothness_.maxTurn)
            atLeast({{arcAt(arriving), 1}, {arcAt(left), -1}, {arcAt(right), -1}}, -1);
    }

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    const ArcGraph& graph_;
    const std::vector<double>& dihedralAngles_;
    const std::vector<double>& edgeCosts_;
    Smoothness smoothness_;
    std::vector<ArcId> arcOf_;   ///< of every edge
    std::vector<bool> inLayout_; ///< of every edge, on a track that is no transversal
    GridProgram result_;
};

} // namespace

double GridProgram::segments(const ColumnValues& values) const {
    double sum = corners;
    for (const ColumnId column : values.ids())
        sum += quarters[column] * values[column];
    return sum / 4;
}

ColumnValues GridProgram::valuesOf(const std::vector<bool>& present) const {
    ColumnValues values(present.begin(), present.end());
    for (const Indicator& indicator : indicators) {
        const bool any = std::ranges::any_of(indicator.arcs, [&](ArcId arc) { return present[arc.idx()]; });
        values.push_back(any == indicator.ofAny ? 1 : 0);
    }
    return values;
}

GridProgram gridProgram(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
                        const std::vector<double>& dihedralAngles, const std::vector<double>& edgeCosts,
                        const Layout& layout, const Smoothness& smoothness) {
    return Builder(mesh, complex, graph, dihedralAngles, edgeCosts, smoothness).build(layout);
}

} // namespace qm
