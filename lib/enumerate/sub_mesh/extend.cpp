#include "enumerate/sub_mesh/extend.h"

#include "enumerate/sub_mesh/line_walk.h"

#include <set>
#include <utility>

namespace qm {
namespace {

/// Keeps the arcs that each free particle would walk up to date while others walk.
class Extender {
public:
    Extender(const ArcGraph& graph, const IdVector<ArcId, double>& arcCosts, PresentArcs& present)
        : graph_(graph), arcCosts_(arcCosts), present_(present), particles_(freeParticles(graph, present)),
          plans_(particles_.size()), ofLine_(graph.lines.size(), {none, none}) {
        for (std::size_t i = 0; i < particles_.size(); ++i) {
            ofLine_[particles_[i].line][particles_[i].fromEnd ? 1 : 0] = i;
            plan(i);
        }
    }

    std::size_t run() {
        std::size_t extended = 0;
        while (!queue_.empty()) {
            const std::size_t i = queue_.begin()->second;
            const Plan walked = plans_[i];
            ++extended;
            for (int k = walked.begin; k < walked.end; ++k)
                present_[walk(i).arc(k)] = true;
            for (int k = walked.begin; k < walked.end; ++k)
                reconsiderBeside(walk(i).arc(k));
            reconsiderLine(particles_[i].line);
        }
        return extended;
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// The arcs `begin` to `end` - 1 of a particle's way, counted from its source.
    struct Plan {
        int begin = 0;
        int end = 0;
        double cost = 0;
        bool free = false;
    };

    [[nodiscard]] LineWalk walk(std::size_t i) const { return {graph_, particles_[i]}; }

    void plan(std::size_t i) {
        Plan& plan = plans_[i];
        if (plan.free) queue_.erase({plan.cost, i});
        const LineWalk way = walk(i);
        plan.begin = plan.end = way.covered(present_);
        plan.free = plan.begin < way.arcCount() && !way.blocked(plan.begin, present_);
        if (!plan.free) return;
        do
            ++plan.end;
        while (plan.end < way.arcCount() && !way.blocked(plan.end, present_) && !present_[way.arc(plan.end)]);
        plan.cost = 0;
        // In the line's order, so that the walks of both particles over the same arcs cost exactly the same.
        for (int k = 0; k < plan.end - plan.begin; ++k)
            plan.cost += arcCosts_[way.arc(particles_[i].fromEnd ? plan.end - 1 - k : plan.begin + k)];
        queue_.emplace(plan.cost, i);
    }

    void reconsiderLine(LineId line) {
        for (const std::size_t i : ofLine_[line])
            if (i != none && plans_[i].free) plan(i);
    }

    /// Plans the walks over both ends of a new arc again, because they may stop there now.
    void reconsiderBeside(ArcId arc) {
        const Line& line = graph_.lineOf(arc);
        reconsiderAt(graph_.junctionAfter[arc], arc);
        if (arc != line.firstArc) reconsiderAt(graph_.junctionAfter[arc - 1], arc);
    }

    void reconsiderAt(JunctionId id, ArcId arc) {
        if (!id.valid()) return;
        for (const ArcId crossing : graph_.junctions[id].across(arc))
            if (crossing.valid())
                for (const std::size_t i : ofLine_[graph_.arcs[crossing].line])
                    if (i != none && plans_[i].free && reaches(i, crossing)) plan(i);
    }

    /// Whether the particle would walk an arc, or has walked it last.
    [[nodiscard]] bool reaches(std::size_t i, ArcId arc) const {
        const Line& line = graph_.lines[particles_[i].line];
        const int position = arc.value() - line.firstArc.value();
        const int walked = particles_[i].fromEnd ? line.arcCount - 1 - position : position;
        return walked >= plans_[i].begin - 1 && walked < plans_[i].end;
    }

    const ArcGraph& graph_;
    const IdVector<ArcId, double>& arcCosts_;
    PresentArcs& present_;
    std::vector<Particle> particles_;
    std::vector<Plan> plans_;                             ///< of every particle
    IdVector<LineId, std::array<std::size_t, 2>> ofLine_; ///< of every line: from begin and from end
    std::set<std::pair<double, std::size_t>> queue_;      ///< free particles, cheapest walk first
};

} // namespace

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

std::size_t extendCheapestFirst(const ArcGraph& graph, const IdVector<ArcId, double>& arcCosts,
                                PresentArcs& present) {
    return Extender(graph, arcCosts, present).run();
}

} // namespace qm
