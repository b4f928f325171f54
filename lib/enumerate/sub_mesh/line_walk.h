/// \file The arcs and junctions on the way of a particle along its line.
#pragma once

#include "enumerate/sub_mesh/extend.h"

#include <vector>

namespace qm {

/// Walks a line from one of its ends.
class LineWalk {
public:
    LineWalk(const ArcGraph& graph, Particle particle)
        : graph_(graph), line_(graph.lines[particle.line]), fromEnd_(particle.fromEnd) {}

    [[nodiscard]] int arcCount() const { return line_.arcCount; }
    /// The arc that follows after `walked` arcs.
    [[nodiscard]] ArcId arc(int walked) const {
        return fromEnd_ ? line_.lastArc() - walked : line_.firstArc + walked;
    }
    /// The junction reached after `walked` arcs, at least one; none at the far end.
    [[nodiscard]] JunctionId junction(int walked) const {
        if (walked >= line_.arcCount) return {};
        return graph_.junctionAfter[arc(fromEnd_ ? walked : walked - 1)];
    }
    /// The number of arcs that are present without interruption from the start on.
    [[nodiscard]] int covered(const PresentArcs& present) const {
        int count = 0;
        while (count < line_.arcCount && present[arc(count)])
            ++count;
        return count;
    }
    /// Whether both arcs of the crossing line are present at the junction reached.
    [[nodiscard]] bool blocked(int walked, const PresentArcs& present) const {
        const JunctionId id = junction(walked);
        if (!id.valid()) return false;
        const auto [a, b] = graph_.junctions[id].across(arc(walked - 1));
        return a.valid() && b.valid() && present[a] && present[b];
    }

private:
    const ArcGraph& graph_;
    const Line& line_;
    bool fromEnd_;
};

} // namespace qm
