#include "merge/free_particles.h"

namespace qm {

FreeParticles::FreeParticles(const SearchSpace& space, const PresentArcs& present)
    : space_(space), present_(present), placeOf_(2 * space.graph.lines.size()) {
    for (const Particle particle : freeParticles(space.graph, present))
        place(particle);
}

const std::set<Particle>& FreeParticles::in(SubMeshId subMesh) const {
    static const std::set<Particle> nobody;
    const auto found = waiting_.find(subMesh);
    return found == waiting_.end() ? nobody : found->second;
}

void FreeParticles::update(const std::vector<ArcId>& changed) {
    const ArcGraph& graph = space_.graph;
    std::set<LineId> lines;
    const auto addLinesAt = [&](JunctionId junction) {
        if (!junction.valid()) return;
        for (const ArcId arc : graph.junctions[junction].arcs)
            if (arc.valid()) lines.insert(graph.arcs[arc].line);
    };
    for (const ArcId arc : changed) {
        const Line& line = graph.lineOf(arc);
        lines.insert(graph.arcs[arc].line);
        addLinesAt(arc == line.firstArc ? line.beginsAt : graph.junctionAfter[arc - 1]);
        addLinesAt(arc == line.lastArc() ? line.endsAt : graph.junctionAfter[arc]);
    }
    for (const LineId line : lines) {
        place({line, false});
        if (graph.lines[line].backward) place({line, true});
    }
}

void FreeParticles::place(Particle particle) {
    SubMeshId& place = placeOf_[2 * particle.line.idx() + (particle.fromEnd ? 1 : 0)];
    if (place.valid()) count_ -= waiting_[place].erase(particle);
    const JunctionId end = freeEnd(space_.graph, particle, present_);
    place = end.valid() ? space_.junctionLabels[end] : SubMeshId();
    if (place.valid() && waiting_[place].insert(particle).second) ++count_;
}

} // namespace qm
