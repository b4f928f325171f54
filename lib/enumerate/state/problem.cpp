#include "enumerate/state/problem.h"

#include "base/error.h"
#include "enumerate/state/crack_nodes.h"
#include "enumerate/state/sparse_index.h"

#include <algorithm>
#include <string>

namespace qm {
namespace {

/// The stretch of a line that holds its free arcs, and what comes before and after it.
struct Stretch {
    int first = 0; ///< positions on the line
    int last = -1;
    bool beforeIn = false;       ///< the arc before it is in, or a source is there
    bool beforeAnchored = false; ///< all arcs before it are in, from a source
    bool afterIn = false;
    bool afterAnchored = false;
};

class Maker {
public:
    explicit Maker(const ProblemInput& input) : input_(input), graph_(input.graph) {}

    Problem make() {
        if (input_.lines.empty())
            for (std::size_t line = 0; line < graph_.lines.size(); ++line)
                addChain(LineId(line));
        for (const LineId line : input_.lines)
            addChain(line);
        problem_.domains.push_back(ArcState::in);
        problem_.domains.push_back(ArcState::out);
        problem_.costs.insert(problem_.costs.end(), {0.0, 0.0});
        const std::vector<JunctionId> junctions = junctionsOfChains();
        CrackNodes nodes = crackNodes(input_, problem_.chains, chainOf_, linesAt(junctions));
        problem_.nodes = std::move(nodes.nodes);
        nodeOf_ = std::move(nodes.nodeOf);
        for (const JunctionId junction : junctions)
            addCrossing(junction);
        return std::move(problem_);
    }

private:
    /// No other takes part in anything that is left to decide.
    std::vector<JunctionId> junctionsOfChains() const {
        std::vector<JunctionId> junctions;
        for (const LineId id : chainLines_) {
            const Line& line = graph_.lines[id.idx()];
            junctions.insert(junctions.end(), {line.beginsAt, line.endsAt});
            const auto inner = graph_.junctionAfter.begin() + line.firstArc.value();
            junctions.insert(junctions.end(), inner, inner + line.arcCount - 1);
        }
        std::erase_if(junctions, [](JunctionId junction) { return !junction.valid(); });
        std::ranges::sort(junctions);
        junctions.erase(std::unique(junctions.begin(), junctions.end()), junctions.end());
        return junctions;
    }

    std::vector<LineId> linesAt(const std::vector<JunctionId>& junctions) const {
        std::vector<LineId> lines = chainLines_;
        for (const JunctionId id : junctions)
            for (const ArcId arc : graph_.junctions[id.idx()].arcs)
                if (arc.valid()) lines.push_back(graph_.arcs[arc.idx()].line);
        std::ranges::sort(lines);
        lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
        return lines;
    }

    ArcState state(const Line& line, int position) const { return input_.states[line.firstArc + position]; }

    bool allIn(const Line& line, int begin, int end) const {
        for (int k = begin; k < end; ++k)
            if (state(line, k) != ArcState::in) return false;
        return true;
    }

    Stretch stretchOf(LineId id) const {
        const Line& line = graph_.lines[id.idx()];
        Stretch stretch;
        stretch.first = line.arcCount;
        for (int k = 0; k < line.arcCount; ++k)
            if (state(line, k) == ArcState::free) {
                stretch.first = std::min(stretch.first, k);
                stretch.last = k;
            }
        if (stretch.last < 0) return stretch;
        const bool atBegin = stretch.first == 0, atEnd = stretch.last == line.arcCount - 1;
        const bool sourceAtBegin = input_.walkers.begin(id),
                   sourceAtEnd = line.backward && input_.walkers.end(id);
        stretch.beforeAnchored = sourceAtBegin && allIn(line, 0, stretch.first);
        stretch.beforeIn = atBegin ? sourceAtBegin : state(line, stretch.first - 1) == ArcState::in;
        stretch.afterAnchored = sourceAtEnd && allIn(line, stretch.last + 1, line.arcCount);
        stretch.afterIn = atEnd ? sourceAtEnd : state(line, stretch.last + 1) == ArcState::in;
        return stretch;
    }

    void addChain(LineId id) {
        const Stretch stretch = stretchOf(id);
        if (stretch.last < 0) return;
        chainOf_.put(id, problem_.chains.nextId());
        chainLines_.push_back(id);
        const ArcId meeting = input_.walkers.meeting(id);
        const int met = meeting.valid() ? meeting.value() - graph_.lines[id.idx()].firstArc.value() : -1;
        if (met < stretch.first || met >= stretch.last) return addStretch(id, stretch);
        // Neither particle gets beyond the place where they meet.
        Stretch first = stretch, second = stretch;
        first.last = met;
        first.afterIn = first.afterAnchored = false;
        second.first = met + 1;
        second.beforeIn = second.beforeAnchored = false;
        addStretch(id, first);
        addStretch(id, second);
    }

    void addStretch(LineId id, const Stretch& stretch) {
        const VariableId first = problem_.arcs.nextId();
        for (int k = stretch.first; k <= stretch.last; ++k)
            addArc(graph_.lines[id.idx()], k, k > stretch.first, domainOf(id, stretch, k));
        problem_.chains.push_back({first, problem_.arcs.nextId().value() - first.value(),
                                   stretch.beforeAnchored, stretch.afterAnchored});
    }

    ArcState domainOf(LineId id, const Stretch& stretch, int k) const {
        const Line& line = graph_.lines[id.idx()];
        const ArcId arc = line.firstArc + k;
        // A track that goes on beyond the stretch without a source of its own must be reached from here.
        const bool mustCover =
            (stretch.beforeIn && !stretch.beforeAnchored) || (stretch.afterIn && !stretch.afterAnchored);
        const bool unreachable = !stretch.beforeAnchored && !stretch.afterAnchored && !mustCover;
        const bool atSource = (k == 0 && input_.walkers.begin(id)) ||
                              (k == line.arcCount - 1 && line.backward && input_.walkers.end(id));
        ArcState domain = state(line, k);
        if (atSource || mustCover) restrict(arc, domain, ArcState::in);
        if (unreachable) restrict(arc, domain, ArcState::out);
        if (!input_.demands.empty()) restrict(arc, domain, input_.demands[arc.idx()]);
        return domain;
    }

    /// Gives an arc a variable of its own, or that of the arc before it where nothing can end between them.
    void addArc(const Line& line, int k, bool mayJoin, ArcState domain) {
        const ArcId arc = line.firstArc + k;
        if (mayJoin && passesFreely(arc - 1)) {
            restrict(arc, problem_.domains.back(), domain);
            ++problem_.arcs.back().count;
            problem_.costs.back() += input_.arcCosts[arc.idx()];
        } else {
            problem_.arcs.push_back({arc, 1});
            problem_.costs.push_back(input_.arcCosts[arc.idx()]);
            problem_.domains.push_back(domain);
        }
        variableOf_.put(arc, problem_.arcs.nextId() - 1);
    }

    /// No track can end at the junction after an arc: nothing crosses there.
    bool passesFreely(ArcId arc) const {
        const JunctionId id = graph_.junctionAfter[arc.idx()];
        const Junction& junction = graph_.junctions[id.idx()];
        if (input_.open.contains(id)) return false;
        const std::size_t other = junction.arcs[0] == arc || junction.arcs[2] == arc ? 1 : 0;
        const auto isOut = [&](ArcId crossing) {
            return !crossing.valid() || input_.states[crossing] == ArcState::out;
        };
        return isOut(junction.arcs[other]) && isOut(junction.arcs[other + 2]);
    }

    void restrict(ArcId arc, ArcState& domain, ArcState demand) const {
        if (demand == ArcState::free || demand == domain) return;
        if (domain != ArcState::free) contradiction(arc, demand);
        domain = demand;
    }

    [[noreturn]] void contradiction(ArcId arc, ArcState demand) const {
        const JunctionId junction = graph_.junctionAfter[arc.idx()];
        const std::string place =
            "separatrix " + std::to_string(graph_.lineOf(arc).forward.value()) +
            (junction.valid()
                 ? " before vertex " + std::to_string(graph_.junctions[junction.idx()].vertex.idx())
                 : std::string(", last arc"));
        throw Error(place,
                    demand == ArcState::out ? "it is forbidden, but every motorcycle graph needs it"
                                            : "it is required, but no motorcycle graph can have it",
                    "take the edge out of /constraints");
    }

    ChainId chainOfArc(ArcId arc) const { return chainOf_[graph_.arcs[arc.idx()].line]; }

    VariableId variable(ArcId arc) const {
        if (!arc.valid()) return problem_.out();
        const VariableId variable = variableOf_[arc];
        if (variable.valid()) return variable;
        return input_.states[arc] == ArcState::in ? problem_.in() : problem_.out();
    }

    CrossingSide side(JunctionId id, std::size_t k) const {
        const Junction& junction = graph_.junctions[id.idx()];
        const LineId line = graph_.arcs[junction.arcs[k].idx()].line;
        const bool ends = junction.seeded && k == 0;
        return {variable(junction.arcs[k]), variable(junction.arcs[k + 2]),
                ends ? CrackNodeId() : nodeOf_[line]};
    }

    /// One line is absent and the other a single variable or a seed's, so that no rule is left to obey.
    bool isSettled(const Junction& junction) const {
        for (const std::size_t k : {0U, 1U}) {
            const bool together =
                variable(junction.arcs[k]) == variable(junction.arcs[k + 2]) || (junction.seeded && k == 0);
            if (together && variable(junction.arcs[1 - k]) == problem_.out() &&
                variable(junction.arcs[3 - k]) == problem_.out())
                return true;
        }
        return false;
    }

    /// The two particles of a line can only meet here, so that neither passes.
    bool isMeeting(const Junction& junction) const {
        for (const std::size_t k : {0U, 1U}) {
            const ArcId before = std::min(junction.arcs[k], junction.arcs[k + 2]);
            if (before.valid() && input_.walkers.meeting(graph_.arcs[before.idx()].line) == before)
                return true;
        }
        return false;
    }

    void addCrossing(JunctionId id) {
        const Junction& junction = graph_.junctions[id.idx()];
        if (!junction.crossed() || isSettled(junction) || isMeeting(junction)) return;
        bool anyFree = false, anyOut = false, onChain = false;
        for (const ArcId arc : junction.arcs) {
            anyFree = anyFree || !problem_.isConstant(variable(arc));
            anyOut = anyOut || variable(arc) == problem_.out();
            onChain = onChain || (arc.valid() && chainOfArc(arc).valid());
        }
        if (input_.open.contains(id) ? !anyOut && onChain : anyFree || (!anyOut && onChain))
            problem_.crossings.push_back({{side(id, 0), side(id, 1)},
                                          input_.open.contains(id),
                                          input_.open.contains(id) ? 0 : input_.cornerCost});
    }

    const ProblemInput& input_;
    const ArcGraph& graph_;
    SparseIndex<ArcId, VariableId> variableOf_;
    SparseIndex<LineId, ChainId> chainOf_;
    std::vector<LineId> chainLines_; ///< that have a chain, ascending
    SparseIndex<LineId, CrackNodeId> nodeOf_;
    Problem problem_;
};

} // namespace

Problem makeProblem(const ProblemInput& input) {
    return Maker(input).make();
}

} // namespace qm
