#include "enumerate/sub_mesh/extend.h"

#include "enumerate/state/search_state.h"

namespace qm {
namespace {

/// Walks along a line from one of its ends.
class Walk {
public:
    Walk(const ArcGraph& graph, Particle particle)
        : graph_(graph), line_(graph.lines[particle.line.idx()]), fromEnd_(particle.fromEnd) {}

    [[nodiscard]] int arcCount() const { return line_.arcCount; }
    /// The arc after `walked` arcs.
    [[nodiscard]] ArcId arc(int walked) const {
        return ArcId(line_.firstArc.value() + (fromEnd_ ? line_.arcCount - 1 - walked : walked));
    }
    /// The junction reached after `walked` arcs, at least one; invalid at the far end.
    [[nodiscard]] JunctionId junction(int walked) const {
        if (walked >= line_.arcCount) return {};
        return graph_.junctionAfter[fromEnd_ ? arc(walked).idx() : arc(walked - 1).idx()];
    }
    /// Arcs present from the start on.
    [[nodiscard]] int covered(const std::vector<bool>& present) const {
        int count = 0;
        while (count < line_.arcCount && present[arc(count).idx()])
            ++count;
        return count;
    }
    /// Both arcs of the line that crosses at the junction reached are present.
    [[nodiscard]] bool blocked(int walked, const std::vector<bool>& present) const {
        const JunctionId id = junction(walked);
        if (!id.valid()) return false;
        const Junction& junction = graph_.junctions[id.idx()];
        const ArcId here = arc(walked - 1);
        const std::size_t other = junction.arcs[0] == here || junction.arcs[2] == here ? 1 : 0;
        const ArcId a = junction.arcs[other], b = junction.arcs[other + 2];
        return a.valid() && b.valid() && present[a.idx()] && present[b.idx()];
    }

private:
    const ArcGraph& graph_;
    const Line& line_;
    bool fromEnd_;
};

} // namespace

int extendParticle(const ArcGraph& graph, Particle particle, std::vector<bool>& present,
                   const std::vector<bool>& open) {
    const Walk walk(graph, particle);
    int walked = walk.covered(present), added = 0;
    const auto stops = [&] {
        if (walked == walk.arcCount()) return true;
        if (walked == 0) return false;
        const JunctionId junction = walk.junction(walked);
        return walk.blocked(walked, present) || (!open.empty() && open[junction.idx()]);
    };
    while (!stops() && !present[walk.arc(walked).idx()]) {
        present[walk.arc(walked).idx()] = true;
        ++walked;
        ++added;
    }
    return added;
}

std::vector<Particle> particlesOf(const ArcGraph& graph) {
    std::vector<Particle> particles;
    for (std::size_t line = 0; line < graph.lines.size(); ++line) {
        particles.push_back({LineId(line), false});
        if (graph.lines[line].backward) particles.push_back({LineId(line), true});
    }
    return particles;
}

JunctionId crashJunction(const ArcGraph& graph, Particle particle, const std::vector<bool>& present) {
    const Walk walk(graph, particle);
    const int covered = walk.covered(present);
    return covered == 0 ? JunctionId{} : walk.junction(covered);
}

std::vector<Particle> freeParticles(const ArcGraph& graph, const std::vector<bool>& present) {
    std::vector<Particle> result;
    for (const Particle particle : particlesOf(graph)) {
        const Walk walk(graph, particle);
        const int covered = walk.covered(present);
        if (covered > 0 && covered < walk.arcCount() && !walk.blocked(covered, present))
            result.push_back(particle);
    }
    return result;
}

bool isMotorcycleGraph(const ArcGraph& graph, const std::vector<bool>& present, bool gaps) {
    const std::vector<double> costs(graph.arcs.size(), 0);
    Problem problem = makeProblem({graph, costs, std::vector(graph.arcs.size(), ArcState::free), {}, {}, {}});
    problem.gaps = gaps;
    SearchState state(problem);
    if (!state.consistent()) return false;
    for (int v = 0; v < problem.variables(); ++v) {
        const ArcRun& run = problem.arcs[static_cast<std::size_t>(v)];
        const bool in = present[run.first.idx()];
        for (int k = 1; k < run.count; ++k)
            if (present[static_cast<std::size_t>(run.first.value() + k)] != in) return false;
        if (state.isFree(v) ? !state.assign(v, in ? ArcState::in : ArcState::out)
                            : state.value(v) != (in ? ArcState::in : ArcState::out))
            return false;
    }
    return true;
}

} // namespace qm
