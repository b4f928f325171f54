#include "enumerate/diagram/count_graphs.h"

#include "enumerate/diagram/count_and_draw.h"
#include "enumerate/state/independent_parts.h"
#include "enumerate/state/search_state.h"

namespace qm {
namespace {

/// Counts by recursion over independent parts, for problems whose diagram would be too large.
class Counter {
public:
    Counter(const Problem& problem, const Control& control) : state_(problem), control_(control) {}

    std::optional<BigCount> run() {
        if (!state_.consistent()) return BigCount(0);
        const BigCount count = countAll(independentParts(state_));
        if (stopped_) return std::nullopt;
        return count;
    }

private:
    BigCount countAll(const std::vector<std::vector<VariableId>>& parts) {
        BigCount product = 1;
        for (const auto& part : parts) {
            product *= countPart(part);
            if (product == 0) break;
        }
        return product;
    }

    /// Sets one variable to both values in turn, and counts the rest of the part, which may fall apart.
    BigCount countPart(const std::vector<VariableId>& part) {
        stopped_ = stopped_ || control_.stopRequested(); // a step may take milliseconds
        if (stopped_) return 0;
        BigCount sum = 0;
        for (const ArcState value : {ArcState::in, ArcState::out}) {
            const SearchState::Mark mark = state_.mark();
            if (state_.assign(part.front(), value)) sum += countAll(independentParts(state_, part));
            state_.undo(mark);
        }
        return sum;
    }

    SearchState state_;
    const Control& control_;
    bool stopped_ = false;
};

} // namespace

std::optional<BigCount> countGraphs(const Problem& problem, const Control& control) {
    if (const auto diagram = buildDiagram(problem, diagramNodes, control))
        return countPaths(*diagram)[diagram->root];
    return countByParts(problem, control);
}

std::optional<BigCount> countByParts(const Problem& problem, const Control& control) {
    return Counter(problem, control).run();
}

} // namespace qm
