#include "enumerate/state/line_stretch.h"

#include "base/error.h"

#include <algorithm>
#include <string>

namespace qm {
namespace {

ArcState stateAt(const ProblemInput& input, const Line& line, int position) {
    return input.states[line.firstArc + position];
}

bool allIn(const ProblemInput& input, const Line& line, int begin, int end) {
    for (int k = begin; k < end; ++k)
        if (stateAt(input, line, k) != ArcState::in) return false;
    return true;
}

bool hasSourceAtEnd(const ProblemInput& input, LineId line) {
    return input.graph.lines[line].backward && input.walkers.fromEnd(line);
}

/// The stretch from the first free arc to the last; `last` is negative if there is none.
LineStretch wholeStretch(const ProblemInput& input, LineId id) {
    const Line& line = input.graph.lines[id];
    LineStretch stretch;
    stretch.first = line.arcCount;
    for (int k = 0; k < line.arcCount; ++k)
        if (stateAt(input, line, k) == ArcState::free) {
            stretch.first = std::min(stretch.first, k);
            stretch.last = k;
        }
    if (stretch.last < 0) return stretch;
    const bool atBegin = stretch.first == 0, atEnd = stretch.last == line.arcCount - 1;
    const bool sourceAtBegin = input.walkers.fromBegin(id), sourceAtEnd = hasSourceAtEnd(input, id);
    stretch.beforeAnchored = sourceAtBegin && allIn(input, line, 0, stretch.first);
    stretch.beforeIn = atBegin ? sourceAtBegin : stateAt(input, line, stretch.first - 1) == ArcState::in;
    stretch.afterAnchored = sourceAtEnd && allIn(input, line, stretch.last + 1, line.arcCount);
    stretch.afterIn = atEnd ? sourceAtEnd : stateAt(input, line, stretch.last + 1) == ArcState::in;
    return stretch;
}

[[noreturn]] void throwContradiction(const ArcGraph& graph, ArcId arc, ArcState demand) {
    const JunctionId junction = graph.junctionAfter[arc];
    const std::string place =
        "separatrix " + std::to_string(graph.lineOf(arc).forward.value()) +
        (junction.valid() ? " before vertex " + std::to_string(graph.junctions[junction].vertex.idx())
                          : std::string(", last arc"));
    throw Error(place,
                demand == ArcState::out ? "it is forbidden, but every motorcycle graph needs it"
                                        : "it is required, but no motorcycle graph can have it",
                "Take the edge out of /constraints");
}

} // namespace

std::vector<LineStretch> stretchesOf(const ProblemInput& input, LineId line) {
    const LineStretch whole = wholeStretch(input, line);
    if (whole.last < 0) return {};
    const ArcId meeting = input.walkers.meeting(line);
    const int met = meeting.valid() ? meeting.value() - input.graph.lines[line].firstArc.value() : -1;
    if (met < whole.first || met >= whole.last) return {whole};
    LineStretch first = whole, second = whole;
    first.last = met;
    first.afterIn = first.afterAnchored = false;
    second.first = met + 1;
    second.beforeIn = second.beforeAnchored = false;
    return {first, second};
}

ArcState domainOf(const ProblemInput& input, LineId id, const LineStretch& stretch, int position) {
    const Line& line = input.graph.lines[id];
    const ArcId arc = line.firstArc + position;
    // If a track goes on beyond the stretch without a source of its own, its particle must come through here.
    const bool mustCover =
        (stretch.beforeIn && !stretch.beforeAnchored) || (stretch.afterIn && !stretch.afterAnchored);
    const bool unreachable = !stretch.beforeAnchored && !stretch.afterAnchored && !mustCover;
    const bool atSource = (position == 0 && input.walkers.fromBegin(id)) ||
                          (position == line.arcCount - 1 && hasSourceAtEnd(input, id));
    ArcState domain = stateAt(input, line, position);
    if (atSource || mustCover) restrictDomain(input.graph, arc, domain, ArcState::in);
    if (unreachable) restrictDomain(input.graph, arc, domain, ArcState::out);
    if (!input.demands.empty()) restrictDomain(input.graph, arc, domain, input.demands[arc.idx()]);
    return domain;
}

void restrictDomain(const ArcGraph& graph, ArcId arc, ArcState& domain, ArcState demand) {
    if (demand == ArcState::free || demand == domain) return;
    if (domain != ArcState::free) throwContradiction(graph, arc, demand);
    domain = demand;
}

} // namespace qm
