#include "enumerate/sub_mesh/extend.h"

#include "enumerate/sub_mesh/line_walk.h"

namespace qm {

void extendParticle(const ArcGraph& graph, Particle particle, PresentArcs& present,
                    const OpenJunctions& open) {
    const LineWalk walk(graph, particle);
    const auto stops = [&](int walked) {
        if (walked == walk.arcCount()) return true;
        return walked > 0 && (walk.blocked(walked, present) || open.contains(walk.junction(walked)));
    };
    for (int walked = walk.covered(present); !stops(walked) && !present[walk.arc(walked)]; ++walked)
        present[walk.arc(walked)] = true;
}

JunctionId freeEnd(const ArcGraph& graph, Particle particle, const PresentArcs& present) {
    const LineWalk walk(graph, particle);
    const int covered = walk.covered(present);
    return covered > 0 && !walk.blocked(covered, present) ? walk.junction(covered) : JunctionId();
}

std::vector<Particle> freeParticles(const ArcGraph& graph, const PresentArcs& present) {
    std::vector<Particle> result;
    const auto addIfFree = [&](Particle particle) {
        if (freeEnd(graph, particle, present).valid()) result.push_back(particle);
    };
    for (const LineId line : graph.lines.ids()) {
        addIfFree({line, false});
        if (graph.lines[line].backward) addIfFree({line, true});
    }
    return result;
}

} // namespace qm
