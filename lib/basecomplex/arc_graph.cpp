#include "basecomplex/arc_graph.h"

#include "base/at.h"
#include "mesh/topology.h"

namespace qm {
namespace {

/// One line for every pair of opposite separatrices whose particles can meet, and one for every other
/// separatrix.
IdVector<LineId, Line> findLines(const BaseComplex& complex) {
    IdVector<LineId, Line> lines;
    for (const SeparatrixId id : complex.separatrices.ids()) {
        const Separatrix& separatrix = complex.separatrices[id];
        const auto& opposite = separatrix.opposite;
        const std::size_t length = separatrix.halfedges.size();
        const bool meets = opposite && separatrix.reach + complex.separatrices[*opposite].reach >= length;
        if (!meets)
            lines.push_back({id, std::nullopt, separatrix.reach, ArcId{}, 0});
        else if (*opposite >= id)
            lines.push_back({id, opposite, length, ArcId{}, 0});
    }
    return lines;
}

class Builder {
public:
    Builder(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<SubMeshId>& labels)
        : mesh_(mesh), complex_(complex), labels_(labels), junctionAt_(mesh.n_vertices()) {}

    ArcGraph build() {
        graph_.lines = findLines(complex_);
        placeJunctions();
        for (const LineId line : graph_.lines.ids())
            splitLine(line);
        return std::move(graph_);
    }

private:
    std::span<const HalfedgeId> path(const Line& line) const {
        return std::span(complex_.separatrices[line.forward].halfedges).first(line.length);
    }

    bool besideCut(HalfedgeId arriving, HalfedgeId leaving) const {
        if (labels_.empty()) return false;
        const SubMeshId label = labels_[at(mesh_.to_vertex_handle(arriving))];
        return label != labels_[at(mesh_.from_vertex_handle(arriving))] ||
               label != labels_[at(mesh_.to_vertex_handle(leaving))];
    }

    void placeJunctions() {
        std::vector<int> passes(mesh_.n_vertices(), 0);
        std::vector<bool> stop(mesh_.n_vertices(), false);
        for (const Seed seed : complex_.seeds)
            ++passes[at(mesh_.from_vertex_handle(seed.direction))];
        for (const Line& line : graph_.lines)
            countPasses(line, passes, stop);
        for (std::size_t vertex = 0; vertex < stop.size(); ++vertex)
            if (stop[vertex]) {
                junctionAt_[vertex] = graph_.junctions.nextId();
                graph_.junctions.push_back({VertexId(static_cast<int>(vertex)), {}, false});
            }
        // A seed's own arcs come first, whatever the order of the lines; they are set when its lines are
        // split.
        for (const Seed seed : complex_.seeds)
            if (const JunctionId seeded = junctionAt_[at(mesh_.from_vertex_handle(seed.direction))];
                seeded.valid())
                graph_.junctions[seeded].seeded = true;
    }

    void countPasses(const Line& line, std::vector<int>& passes, std::vector<bool>& stop) const {
        const auto halfedges = path(line);
        for (std::size_t k = 1; k < halfedges.size(); ++k) {
            const std::size_t vertex = at(mesh_.from_vertex_handle(halfedges[k]));
            if (++passes[vertex] == 2 || besideCut(halfedges[k - 1], halfedges[k])) stop[vertex] = true;
        }
        if (endsAtOwnTrack(line)) stop[at(mesh_.to_vertex_handle(halfedges.back()))] = true;
    }

    bool endsAtOwnTrack(const Line& line) const {
        return line.length < complex_.separatrices[line.forward].halfedges.size();
    }

    void splitLine(LineId id) {
        Line& line = graph_.lines[id];
        const auto halfedges = path(line);
        const int length = static_cast<int>(halfedges.size());
        line.firstArc = graph_.arcs.nextId();
        int begin = 0;
        for (int k = 1; k <= length; ++k) {
            const JunctionId junction =
                k == length ? JunctionId{} : junctionAt_[at(mesh_.from_vertex_handle(halfedges[at(k)]))];
            if (k < length && !junction.valid()) continue;
            const ArcId arc = graph_.arcs.nextId();
            graph_.arcs.push_back({id, begin, k});
            graph_.junctionAfter.push_back(junction);
            if (junction.valid()) pass(graph_.junctions[junction], arc);
            begin = k;
        }
        line.arcCount = graph_.arcs.nextId().value() - line.firstArc.value();
        const ArcId last = line.lastArc();
        line.beginsAt = attachToSeed(mesh_.from_vertex_handle(halfedges.front()), line.firstArc);
        if (endsAtOwnTrack(line)) {
            line.endsAt = junctionAt_[at(mesh_.to_vertex_handle(halfedges.back()))];
            graph_.junctions[line.endsAt].arcs[1] = last;
        } else {
            line.endsAt = attachToSeed(mesh_.to_vertex_handle(halfedges.back()), last);
        }
    }

    /// Enters a line that passes a junction into the next free pair of arcs; at a seed the first pair is the
    /// seed's.
    static void pass(Junction& junction, ArcId before) {
        const bool second = junction.seeded || junction.arcs[0].valid();
        junction.arcs[second ? 1 : 0] = before;
        junction.arcs[second ? 3 : 2] = before + 1;
    }

    /// Enters the end of a line at a seed as one of the seed's two arcs. Other ends, at extraordinary
    /// vertices or on the boundary, have no junction.
    /// \return the junction; none if there is none
    JunctionId attachToSeed(VertexId end, ArcId arc) {
        const JunctionId junction = junctionAt_[at(end)];
        if (!junction.valid()) return {};
        auto& arcs = graph_.junctions[junction].arcs;
        arcs[arcs[0].valid() ? 2 : 0] = arc;
        return junction;
    }

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    const std::vector<SubMeshId>& labels_;
    std::vector<JunctionId> junctionAt_;
    ArcGraph graph_;
};

} // namespace

ArcGraph buildArcGraph(const QuadMesh& mesh, const BaseComplex& complex,
                       const std::vector<SubMeshId>& labels) {
    return Builder(mesh, complex, labels).build();
}

std::vector<JunctionId> junctionsOf(const ArcGraph& graph, LineId id) {
    const Line& line = graph.lines[id];
    std::vector<JunctionId> junctions{line.beginsAt};
    const auto inner = graph.junctionAfter.begin() + line.firstArc.value();
    junctions.insert(junctions.end(), inner, inner + line.arcCount - 1);
    junctions.push_back(line.endsAt);
    std::erase_if(junctions, [](JunctionId junction) { return !junction.valid(); });
    return junctions;
}

std::span<const HalfedgeId> halfedgesOf(const ArcGraph& graph, const BaseComplex& complex, ArcId arc) {
    return halfedgesOf(graph, complex, ArcRun{arc, 1});
}

std::span<const HalfedgeId> halfedgesOf(const ArcGraph& graph, const BaseComplex& complex,
                                        const ArcRun& run) {
    const std::span path(complex.separatrices[graph.lineOf(run.first).forward].halfedges);
    const int begin = graph.arcs[run.first].begin, end = graph.arcs[run.last()].end;
    return path.subspan(at(begin), at(end - begin));
}

std::vector<ArcId> arcsOfEdges(const QuadMesh& mesh, const ArcGraph& graph, const BaseComplex& complex) {
    std::vector<ArcId> result(mesh.n_edges());
    for (const ArcId arc : graph.arcs.ids())
        for (const HalfedgeId halfedge : halfedgesOf(graph, complex, arc))
            result[at(mesh.edge_handle(halfedge))] = arc;
    return result;
}

IdVector<ArcId, double> sumOverArcs(const QuadMesh& mesh, const ArcGraph& graph, const BaseComplex& complex,
                                    const std::vector<double>& perEdge) {
    IdVector<ArcId, double> sums;
    sums.reserve(graph.arcs.size());
    for (const ArcId arc : graph.arcs.ids())
        sums.push_back(sumAlong(mesh, halfedgesOf(graph, complex, arc), perEdge));
    return sums;
}

} // namespace qm
