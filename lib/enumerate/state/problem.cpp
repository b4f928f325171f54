#include "enumerate/state/problem.h"

#include "base/sort_unique.h"
#include "base/sparse_id_vector.h"
#include "enumerate/state/crack_nodes.h"
#include "enumerate/state/line_stretch.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace qm {
namespace {

class Maker {
public:
    explicit Maker(const ProblemInput& input) : input_(input), graph_(input.graph) {}

    Problem make() {
        if (input_.lines)
            for (const LineId line : *input_.lines)
                addChain(line);
        else
            for (std::size_t line = 0; line < graph_.lines.size(); ++line)
                addChain(LineId(line));
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
    /// Where anything is left to decide: at junctions of lines that have a chain.
    std::vector<JunctionId> junctionsOfChains() const {
        std::vector<JunctionId> junctions;
        for (const LineId line : chainLines_)
            std::ranges::copy(junctionsOf(graph_, line), std::back_inserter(junctions));
        sortUnique(junctions);
        return junctions;
    }

    std::vector<LineId> linesAt(const std::vector<JunctionId>& junctions) const {
        std::vector<LineId> lines = chainLines_;
        for (const JunctionId id : junctions)
            for (const ArcId arc : graph_.junctions[id].arcs)
                if (arc.valid()) lines.push_back(graph_.arcs[arc].line);
        sortUnique(lines);
        return lines;
    }

    void addChain(LineId id) {
        const std::vector<LineStretch> stretches = stretchesOf(input_, id);
        if (stretches.empty()) return;
        chainOf_.at(id) = problem_.chains.nextId();
        chainLines_.push_back(id);
        for (const LineStretch& stretch : stretches)
            addStretch(id, stretch);
    }

    void addStretch(LineId id, const LineStretch& stretch) {
        const VariableId first = problem_.arcs.nextId();
        for (int k = stretch.first; k <= stretch.last; ++k)
            addArc(graph_.lines[id], k, k > stretch.first, domainOf(input_, id, stretch, k));
        problem_.chains.push_back({first, problem_.arcs.nextId().value() - first.value(),
                                   stretch.beforeAnchored, stretch.afterAnchored});
    }

    /// Gives an arc a variable of its own, or that of the arc before it where nothing can end between them.
    void addArc(const Line& line, int k, bool mayJoin, ArcState domain) {
        const ArcId arc = line.firstArc + k;
        if (mayJoin && passesFreely(arc - 1)) {
            restrictDomain(graph_, arc, problem_.domains.back(), domain);
            ++problem_.arcs.back().count;
            problem_.costs.back() += input_.arcCosts[arc];
        } else {
            problem_.arcs.push_back({arc, 1});
            problem_.costs.push_back(input_.arcCosts[arc]);
            problem_.domains.push_back(domain);
        }
        variableOf_.at(arc) = problem_.arcs.nextId() - 1;
    }

    /// No track can end at the junction after an arc: nothing crosses there.
    bool passesFreely(ArcId arc) const {
        const JunctionId id = graph_.junctionAfter[arc];
        if (input_.open.contains(id)) return false;
        return std::ranges::all_of(graph_.junctions[id].across(arc), [&](ArcId crossing) {
            return !crossing.valid() || input_.states[crossing] == ArcState::out;
        });
    }

    ChainId chainOfArc(ArcId arc) const { return chainOf_[graph_.arcs[arc].line]; }

    VariableId variable(ArcId arc) const {
        if (!arc.valid()) return problem_.out();
        const VariableId variable = variableOf_[arc];
        if (variable.valid()) return variable;
        return input_.states[arc] == ArcState::in ? problem_.in() : problem_.out();
    }

    CrossingSide side(JunctionId id, std::size_t k) const {
        const Junction& junction = graph_.junctions[id];
        const LineId line = graph_.arcs[junction.arcs[k]].line;
        const bool seeded = junction.isSeedOf(k);
        return {variable(junction.arcs[k]), variable(junction.arcs[k + 2]),
                seeded ? CrackNodeId() : nodeOf_[line], seeded};
    }

    /// One line is absent and the other a single variable or a seed's, so that no rule is left to obey.
    bool isSettled(const Junction& junction) const {
        for (const std::size_t k : {0U, 1U}) {
            const bool together =
                variable(junction.arcs[k]) == variable(junction.arcs[k + 2]) || junction.isSeedOf(k);
            if (together && variable(junction.arcs[1 - k]) == problem_.out() &&
                variable(junction.arcs[3 - k]) == problem_.out())
                return true;
        }
        return false;
    }

    /// The two particles of a line can only meet here, so that neither passes.
    bool isMeeting(const Junction& junction) const {
        for (const std::size_t k : {0U, 1U}) {
            if (junction.isSeedOf(k)) continue; // the seed's particles begin here, and meet elsewhere
            const ArcId before = std::min(junction.arcs[k], junction.arcs[k + 2]);
            if (before.valid() && input_.walkers.meeting(graph_.arcs[before].line) == before) return true;
        }
        return false;
    }

    void addCrossing(JunctionId id) {
        const Junction& junction = graph_.junctions[id];
        if (!junction.crossed() || isSettled(junction) || isMeeting(junction)) return;
        bool anyFree = false, anyOut = false, onChain = false;
        for (const ArcId arc : junction.arcs) {
            anyFree = anyFree || !problem_.isConstant(variable(arc));
            anyOut = anyOut || variable(arc) == problem_.out();
            onChain = onChain || (arc.valid() && chainOfArc(arc).valid());
        }
        const bool open = input_.open.contains(id);
        if (open ? !anyOut && onChain : anyFree || (!anyOut && onChain))
            problem_.crossings.push_back({{side(id, 0), side(id, 1)}, open, open ? 0 : input_.cornerCost});
    }

    const ProblemInput& input_;
    const ArcGraph& graph_;
    SparseIdVector<ArcId, VariableId> variableOf_;
    SparseIdVector<LineId, ChainId> chainOf_;
    std::vector<LineId> chainLines_; ///< that have a chain, ascending
    SparseIdVector<LineId, CrackNodeId> nodeOf_;
    Problem problem_;
};

} // namespace

Problem makeProblem(const ProblemInput& input) {
    return Maker(input).make();
}

} // namespace qm
