#include "enumerate/optimum/part_search.h"

#include <algorithm>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

PartSearch::PartSearch(SearchState& searched, std::vector<int> free, const PartOptions& wanted,
                       const Control& controls)
    : state(searched), variables(std::move(free)), cost(state, variables), options(wanted), control(controls),
      incumbents(options.best, options.maxCost), formulation(formulate(state, variables)),
      particles(state, formulation), relaxation(formulation, particles) {}

bool PartSearch::allDecided() const {
    return std::ranges::none_of(variables, [this](int variable) { return state.isFree(variable); });
}

double PartSearch::present(int variable) const {
    const auto& [fromBefore, fromAfter] = formulation.columnsOf[at(variable)];
    const auto value = [this](int column) { return column < 0 ? 0 : relaxation.values()[at(column)]; };
    return value(fromBefore) + value(fromAfter);
}

void PartSearch::recordLeaf() {
    incumbents.offer(cost.of([this](int variable) { return state.value(variable) == ArcState::in; }),
                     state.assignment());
}

} // namespace qm
