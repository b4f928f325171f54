#include "layout/tracks.h"

#include "base/at.h"
#include "base/error.h"
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
std::vector<Coverage> coverLines(const ArcGraph& graph, const std::vector<bool>& present,
                                 const Walkers& walkers) {
    const std::vector<ArcId> meetings = headOnMeetings(graph, present, walkers);
    std::vector<Coverage> result;
    for (std::size_t i = 0; i < graph.lines.size(); ++i) {
        const Line& line = graph.lines[i];
        const auto in = [&](int k) { return present[at(line.firstArc.value() + k)]; };
        Coverage coverage;
        if (walkers.fromBegin(LineId(i)))
            while (coverage.fromBegin < line.arcCount && in(coverage.fromBegin))
                ++coverage.fromBegin;
        if (meetings[i].valid()) coverage.fromBegin = meetings[i].value() - line.firstArc.value() + 1;
        if (line.backward && walkers.fromEnd(LineId(i)))
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

MotorcycleGraph graphOf(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
                        const std::vector<bool>& present, const std::vector<double>& edgeCosts,
                        const Walkers& walkers) {
    const std::vector<Coverage> coverages = coverLines(graph, present, walkers);
    MotorcycleGraph result;
    const auto add = [&](SeparatrixId separatrix, std::size_t length) {
        if (length == 0) return;
        const std::span path(complex.separatrices[separatrix.idx()].halfedges);
        result.tracks.push_back(trackOf(mesh, path.first(length), edgeCosts));
        result.cost += result.tracks.back().cost;
    };
    for (std::size_t i = 0; i < graph.lines.size(); ++i) {
        const Line& line = graph.lines[i];
        const auto edges = [&](int firstArc, int count) {
            std::size_t sum = 0;
            for (int k = firstArc; k < firstArc + count; ++k)
                sum += halfedgesOf(graph, complex, ArcId(line.firstArc.value() + k)).size();
            return sum;
        };
        const Coverage& coverage = coverages[i];
        add(line.forward, edges(0, coverage.fromBegin));
        if (line.backward) add(*line.backward, edges(line.arcCount - coverage.fromEnd, coverage.fromEnd));
    }
    return result;
}

MotorcycleGraph tMeshOf(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
                        const std::vector<bool>& present, const std::vector<double>& edgeCosts) {
    MotorcycleGraph result;
    for (const Line& line : graph.lines) {
        const auto in = [&](int k) { return k < line.arcCount && present[at(line.firstArc.value() + k)]; };
        for (int first = 0, last = 0; first < line.arcCount; first = last + 1) {
            for (last = first; in(last);)
                ++last;
            if (first == last) continue;
            const auto begin = at(graph.arcs[at(line.firstArc.value() + first)].begin),
                       end = at(graph.arcs[at(line.firstArc.value() + last - 1)].end);
            const bool fromEnd = first > 0 && last == line.arcCount && line.backward;
            const auto& way = complex.separatrices[(fromEnd ? *line.backward : line.forward).idx()].halfedges;
            const std::span path(way);
            result.tracks.push_back(trackOf(
                mesh, fromEnd ? path.first(end - begin) : path.subspan(begin, end - begin), edgeCosts));
            result.cost += result.tracks.back().cost;
        }
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
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        const ArcId id = edges[begin].first;
        while (end < edges.size() && edges[end].first == id)
            ++end;
        if (!id.valid()) continue;
        const Arc& arc = graph.arcs[id.idx()];
        if (end - begin == at(arc.end - arc.begin)) result.push_back(id);
    }
    for (const Track& track : tracks)
        for (const HalfedgeId halfedge : track.halfedges)
            if (!std::ranges::binary_search(result, arcOfEdge[at(edgeOf(halfedge))]))
                throw Error("track over vertex " + std::to_string(mesh.to_vertex_handle(halfedge).idx()),
                            "the tracks do not cover whole arcs of separatrices",
                            "Run the stage that wrote them again");
    return result;
}

std::vector<bool> presentArcs(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
                              const std::vector<Track>& tracks) {
    std::vector<bool> present(graph.arcs.size(), false);
    for (const ArcId arc : coveredArcs(mesh, graph, arcsOfEdges(mesh, graph, complex), tracks))
        present[arc.idx()] = true;
    return present;
}

} // namespace qm
