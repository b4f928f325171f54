#include "enumerate/sub_mesh/search_space.h"

#include "base/at.h"
#include "base/error.h"
#include "base/sort_unique.h"
#include "enumerate/sub_mesh/line_walk.h"
#include "mesh/topology.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace qm {
namespace {

std::string nameOf(const QuadMesh& mesh, EdgeId edge) {
    const auto [from, to] = endsOf(mesh, edge);
    return "edge " + std::to_string(from.idx()) + " " + std::to_string(to.idx());
}

IdVector<ArcId, ArcState> demandsOf(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
                                    const Constraints& constraints) {
    if (constraints.required.empty() && constraints.forbidden.empty()) return {};
    const std::vector<ArcId> arcOf = arcsOfEdges(mesh, graph, complex);
    IdVector<ArcId, ArcState> demands(graph.arcs.size(), ArcState::free);
    const auto demand = [&](EdgeId edge, ArcState state) {
        const ArcId arc = arcOf[at(edge)];
        if (!arc.valid()) return false;
        ArcState& current = demands[arc];
        if (current != ArcState::free && current != state)
            throw Error(nameOf(mesh, edge), "its arc is both required and forbidden",
                        "Take one of them out of /constraints");
        current = state;
        return true;
    };
    for (const EdgeId edge : constraints.required)
        if (!mesh.is_boundary(edge) && !demand(edge, ArcState::in))
            throw Error(nameOf(mesh, edge), "it is required, but no separatrix runs over it",
                        "Add a feature curve there, or take it out of /constraints/required");
    for (const EdgeId edge : constraints.forbidden) {
        if (mesh.is_boundary(edge))
            throw Error(nameOf(mesh, edge), "it is forbidden, but it lies on the mesh boundary",
                        "Take it out of /constraints/forbidden");
        demand(edge, ArcState::out); // edges without a separatrix are absent anyway
    }
    return demands;
}

} // namespace

SearchSpace makeSearchSpace(const QuadMesh& mesh, const BaseComplex& complex, const PlaceCosts& costs,
                            const SubMeshes& subMeshes, const Constraints& constraints) {
    SearchSpace space;
    space.cornerCost = costs.ofCorner;
    space.graph = buildArcGraph(mesh, complex, subMeshes.labels);
    space.arcCosts = sumOverArcs(mesh, space.graph, complex, costs.ofEdges);
    space.demands = demandsOf(mesh, complex, space.graph, constraints);
    for (const ArcId arc : space.graph.arcs.ids()) {
        const auto halfedges = halfedgesOf(space.graph, complex, arc);
        space.arcBegins.push_back(subMeshes.of(mesh.from_vertex_handle(halfedges.front())));
        space.arcEnds.push_back(subMeshes.of(mesh.to_vertex_handle(halfedges.back())));
    }
    // A track that ends on the boundary makes two corners there.
    for (const Line& line : space.graph.lines) {
        const ArcId last = line.lastArc();
        const VertexId end = mesh.to_vertex_handle(halfedgesOf(space.graph, complex, last).back());
        if (!line.backward && mesh.is_boundary(end) && isRegular(mesh, end))
            space.arcCosts[last] += 2 * costs.ofCorner;
    }
    for (const Junction& junction : space.graph.junctions)
        space.junctionLabels.push_back(subMeshes.of(junction.vertex));
    for (const LineId id : space.graph.lines.ids()) {
        const Line& line = space.graph.lines[id];
        const SubMeshId begin = space.arcBegins[line.firstArc];
        const SubMeshId end = space.arcEnds[line.lastArc()];
        space.linesOf[begin].push_back(id);
        if (line.backward && end != begin) space.linesOf[end].push_back(id);
    }
    return space;
}

ProblemInput wholeInput(const SearchSpace& space) {
    return {space.graph, space.arcCosts, {}, space.demands, {}, {}, space.cornerCost};
}

double costOf(const SearchSpace& space, const PresentArcs& present) {
    double cost = 0;
    for (const ArcId arc : present.ids())
        if (present[arc]) cost += space.arcCosts[arc];
    const auto in = [&](ArcId arc) { return arc.valid() && present[arc] ? 1 : 0; };
    for (const Junction& junction : space.graph.junctions)
        cost += space.cornerCost * cornersAt(in(junction.arcs[0]) + in(junction.arcs[2]),
                                             in(junction.arcs[1]) + in(junction.arcs[3]));
    return cost;
}

std::vector<ArcId> walkInside(const SearchSpace& space, Particle particle, SubMeshId subMesh, int from) {
    const LineWalk walk(space.graph, particle);
    const IdVector<ArcId, SubMeshId>& starts = particle.fromEnd ? space.arcEnds : space.arcBegins;
    std::vector<ArcId> arcs;
    for (int walked = from; walked < walk.arcCount() && starts[walk.arc(walked)] == subMesh; ++walked)
        arcs.push_back(walk.arc(walked));
    return arcs;
}

const std::vector<LineId>& linesFrom(const SearchSpace& space, SubMeshId subMesh) {
    static const std::vector<LineId> none;
    const auto found = space.linesOf.find(subMesh);
    return found == space.linesOf.end() ? none : found->second;
}

std::vector<ArcId> ownArcs(const SearchSpace& space, SubMeshId subMesh) {
    std::vector<ArcId> arcs;
    for (const LineId line : linesFrom(space, subMesh)) {
        std::ranges::copy(walkInside(space, {line, false}, subMesh), std::back_inserter(arcs));
        if (space.graph.lines[line].backward)
            std::ranges::copy(walkInside(space, {line, true}, subMesh), std::back_inserter(arcs));
    }
    return arcs;
}

Walkers walkersOf(const SearchSpace& space, SubMeshId subMesh, const PresentArcs& present,
                  const std::vector<LineId>& others) {
    std::unordered_map<LineId, LineWalkers> walkers;
    for (const auto* lines : {&others, &linesFrom(space, subMesh)})
        for (const LineId id : *lines) {
            const Line& line = space.graph.lines[id];
            const ArcId first = line.firstArc, last = line.lastArc();
            std::vector<ArcId> there = walkInside(space, {id, false}, subMesh), back;
            if (line.backward) back = walkInside(space, {id, true}, subMesh);
            const bool meet =
                !there.empty() && !back.empty() && there.size() + back.size() == at(line.arcCount);
            walkers[id] = {space.arcBegins[first] == subMesh || present[first],
                           space.arcEnds[last] == subMesh || present[last], meet ? there.back() : ArcId{}};
        }
    return Walkers(std::move(walkers));
}

Problem subMeshProblem(const SearchSpace& space, SubMeshId subMesh, const std::vector<ArcId>& freeArcs,
                       const PresentArcs& present) {
    std::vector<LineId> lines;
    lines.reserve(freeArcs.size());
    for (const ArcId arc : freeArcs)
        lines.push_back(space.graph.arcs[arc].line);
    sortUnique(lines);
    return makeProblem({space.graph, space.arcCosts, ArcStates(present, freeArcs), space.demands,
                        OpenJunctions(space.junctionLabels, subMesh),
                        walkersOf(space, subMesh, present, lines), space.cornerCost, std::move(lines)});
}

void goStraight(const SearchSpace& space, SubMeshId subMesh, PresentArcs& present) {
    std::vector<Particle> own;
    for (const LineId id : linesFrom(space, subMesh)) {
        const Line& line = space.graph.lines[id];
        if (space.arcBegins[line.firstArc] == subMesh) own.push_back({id, false});
        if (line.backward && space.arcEnds[line.lastArc()] == subMesh) own.push_back({id, true});
    }
    // No particle is idle, so all first arcs must be present before a particle passes a seed.
    for (const Particle particle : own)
        present[LineWalk(space.graph, particle).arc(0)] = true;
    const OpenJunctions open(space.junctionLabels, subMesh);
    for (const Particle particle : own) {
        const LineWalk walk(space.graph, particle);
        const auto stops = [&](int walked) {
            return walked == walk.arcCount() || walk.blocked(walked, present) ||
                   open.contains(walk.junction(walked));
        };
        for (int walked = walk.covered(present); !stops(walked) && !present[walk.arc(walked)]; ++walked)
            present[walk.arc(walked)] = true;
    }
}

} // namespace qm
