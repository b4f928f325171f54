#include "layout/tracks.h"

#include "base/at.h"
#include "base/error.h"
#include "base/groups.h"
#include "base/sort_unique.h"
#include "layout/meetings.h"
#include "mesh/topology.h"

#include <algorithm>
#include <string>
#include <utility>

namespace qm {
namespace {

/// The number of arcs that the two particles of a line have walked. If the line has a gap, they do not meet.
struct Coverage {
    int fromBegin = 0; ///< by the particle from the line's beginning
    int fromEnd = 0;   ///< by the particle from the line's end
};

/// The coverage of every line. A line that is covered from end to end is walked by the particle from its
/// beginning, unless a crossing needs a head-on meeting there (rule 4).
/// \param present  of every arc; the present arcs of a line form a run from each of its sources
/// \param walkers  which particles take part
IdVector<LineId, Coverage> coverLines(const ArcGraph& graph, const PresentArcs& present,
                                      const Walkers& walkers) {
    const IdVector<LineId, ArcId> meetings = headOnMeetings(graph, present, walkers);
    IdVector<LineId, Coverage> result;
    for (const LineId id : graph.lines.ids()) {
        const Line& line = graph.lines[id];
        const auto in = [&](int k) { return present[line.firstArc + k]; };
        Coverage coverage;
        if (walkers.fromBegin(id))
            while (coverage.fromBegin < line.arcCount && in(coverage.fromBegin))
                ++coverage.fromBegin;
        if (meetings[id].valid()) coverage.fromBegin = meetings[id].value() - line.firstArc.value() + 1;
        if (line.backward && walkers.fromEnd(id))
            while (coverage.fromEnd < line.arcCount - coverage.fromBegin &&
                   in(line.arcCount - 1 - coverage.fromEnd))
                ++coverage.fromEnd;
        result.push_back(coverage);
    }
    return result;
}

} // namespace

Track trackOf(const QuadMesh& mesh, std::span<const HalfedgeId> path, const std::vector<double>& edgeCosts) {
    return {{path.begin(), path.end()}, sumAlong(mesh, path, edgeCosts)};
}

MotorcycleGraph graphOf(const MeshArcs& arcs, const PresentArcs& present,
                        const std::vector<double>& edgeCosts, const Walkers& walkers) {
    const ArcGraph& graph = arcs.graph;
    const IdVector<LineId, Coverage> coverages = coverLines(graph, present, walkers);
    MotorcycleGraph result;
    const auto add = [&](SeparatrixId separatrix, const ArcRun& run) {
        const std::span path(arcs.complex.separatrices[separatrix].halfedges);
        result.add(trackOf(arcs.mesh, path.first(halfedgesOf(graph, arcs.complex, run).size()), edgeCosts));
    };
    for (const LineId id : graph.lines.ids()) {
        const Line& line = graph.lines[id];
        const auto& [fromBegin, fromEnd] = coverages[id];
        if (fromBegin > 0) add(line.forward, {line.firstArc, fromBegin});
        if (fromEnd > 0) add(*line.backward, {line.lastArc() - (fromEnd - 1), fromEnd});
    }
    return result;
}

MotorcycleGraph tMeshOf(const MeshArcs& arcs, const PresentArcs& present,
                        const std::vector<double>& edgeCosts) {
    const auto& [mesh, complex, graph] = arcs;
    MotorcycleGraph result;
    for (const Line& line : graph.lines)
        for (const ArcRun& run : runsOf(line, [&](ArcId arc) { return present[arc]; })) {
            auto path = halfedgesOf(graph, complex, run);
            if (run.first != line.firstArc && run.last() == line.lastArc() && line.backward)
                path = std::span(complex.separatrices[*line.backward].halfedges).first(path.size());
            result.add(trackOf(mesh, path, edgeCosts));
        }
    return result;
}

std::vector<ArcId> coveredArcs(const QuadMesh& mesh, const ArcGraph& graph,
                               const std::vector<ArcId>& arcOfEdge, const std::vector<Track>& tracks) {
    const auto edgeOf = [&](HalfedgeId halfedge) { return mesh.edge_handle(halfedge).idx(); };
    std::vector<std::pair<ArcId, int>> edges; // each with its arc
    for (const Track& track : tracks)
        for (const HalfedgeId halfedge : track.halfedges)
            edges.emplace_back(arcOfEdge[at(edgeOf(halfedge))], edgeOf(halfedge));
    sortUnique(edges);
    std::vector<ArcId> result;
    forEachGroup(edges, &std::pair<ArcId, int>::first, [&](const auto& covered) {
        const ArcId id = covered.front().first;
        if (!id.valid()) return;
        const Arc& arc = graph.arcs[id];
        if (covered.size() == at(arc.end - arc.begin)) result.push_back(id);
    });
    for (const Track& track : tracks)
        for (const HalfedgeId halfedge : track.halfedges)
            if (!std::ranges::binary_search(result, arcOfEdge[at(edgeOf(halfedge))]))
                throw Error("track over vertex " + std::to_string(mesh.to_vertex_handle(halfedge).idx()),
                            "the tracks do not cover whole arcs of separatrices",
                            "Run the stage that wrote them again");
    return result;
}

PresentArcs presentArcs(const MeshArcs& arcs, const std::vector<Track>& tracks) {
    const auto& [mesh, complex, graph] = arcs;
    PresentArcs present(graph.arcs.size(), false);
    for (const ArcId arc : coveredArcs(mesh, graph, arcsOfEdges(mesh, graph, complex), tracks))
        present[arc] = true;
    return present;
}

} // namespace qm
