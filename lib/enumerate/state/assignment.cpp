#include "enumerate/state/assignment.h"

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

double costOf(const Problem& problem, const Assignment& assignment) {
    double cost = 0;
    for (int i = 0; i < problem.variables(); ++i)
        if (assignment[static_cast<std::size_t>(i)] == 1) cost += problem.costs[static_cast<std::size_t>(i)];
    const auto present = [&](const CrossingSide& side) {
        return assignment[static_cast<std::size_t>(side.before)] +
               assignment[static_cast<std::size_t>(side.after)];
    };
    for (const Crossing& crossing : problem.crossings)
        if (crossing.cornerCost != 0)
            cost += crossing.cornerCost * cornersAt(present(crossing.sides[0]), present(crossing.sides[1]));
    return cost;
}

Assignment assignmentOf(const Problem& problem, const std::vector<bool>& present) {
    Assignment assignment(problem.domains.size(), 0);
    assignment[at(problem.in())] = 1;
    for (int v = 0; v < problem.variables(); ++v)
        assignment[at(v)] = present[problem.arcs[at(v)].first.idx()] ? 1 : 0;
    return assignment;
}

std::vector<ArcId> differences(const Problem& problem, const Assignment& assignment,
                               const std::vector<bool>& present) {
    std::vector<ArcId> result;
    for (int v = 0; v < problem.variables(); ++v) {
        const ArcRun& run = problem.arcs[at(v)];
        for (int k = 0; k < run.count; ++k)
            if (const ArcId arc(run.first.value() + k); present[arc.idx()] != (assignment[at(v)] == 1))
                result.push_back(arc);
    }
    return result;
}

void apply(const Problem& problem, const Assignment& assignment, std::vector<bool>& present) {
    for (int v = 0; v < problem.variables(); ++v) {
        const ArcRun& run = problem.arcs[at(v)];
        for (int k = 0; k < run.count; ++k)
            present[at(run.first.value() + k)] = assignment[at(v)] == 1;
    }
}

} // namespace qm
