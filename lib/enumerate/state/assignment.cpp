#include "enumerate/state/assignment.h"

#include <algorithm>

namespace qm {

double costOf(const Problem& problem, const Assignment& assignment) {
    double cost = 0;
    for (const VariableId variable : problem.variables())
        if (assignment[variable] == 1) cost += problem.costs[variable];
    for (const Crossing& crossing : problem.crossings)
        if (crossing.cornerCost != 0)
            cost +=
                crossing.cornerCost * crossing.corners([&](VariableId arc) { return assignment[arc] == 1; });
    return cost;
}

Assignment assignmentOf(const Problem& problem, const PresentArcs& present) {
    Assignment assignment(problem.domains.size(), 0);
    assignment[problem.in()] = 1;
    for (const VariableId v : problem.variables())
        assignment[v] = present[problem.arcs[v].first] ? 1 : 0;
    return assignment;
}

std::vector<ArcId> differences(const Problem& problem, const Assignment& assignment,
                               const PresentArcs& present) {
    std::vector<ArcId> result;
    for (const VariableId v : problem.variables())
        for (const ArcId arc : problem.arcs[v].arcs())
            if (present[arc] != (assignment[v] == 1)) result.push_back(arc);
    return result;
}

void apply(const Problem& problem, const Assignment& assignment, PresentArcs& present) {
    for (const VariableId v : problem.variables())
        for (const ArcId arc : problem.arcs[v].arcs())
            present[arc] = assignment[v] == 1;
}

IdVector<ArcId, double> arcValues(const Problem& problem, const IdVector<VariableId, double>& values,
                                  std::size_t arcs) {
    if (values.empty()) return {};
    IdVector<ArcId, double> result(arcs, 0);
    for (const VariableId v : problem.variables())
        std::fill_n(result.begin() + problem.arcs[v].first.value(), problem.arcs[v].count, values[v]);
    return result;
}

} // namespace qm
