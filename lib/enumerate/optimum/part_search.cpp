#include "enumerate/optimum/part_search.h"

#include <algorithm>

namespace qm {

PartSearch::PartSearch(SearchState& searched, std::vector<VariableId> free, const PartOptions& wanted,
                       const Control& controls)
    : state(searched), variables(std::move(free)), cost(state, variables), options(wanted), control(controls),
      incumbents(options.best, options.maxCost), formulation(formulate(state, variables)),
      columns(state, formulation), relaxation(formulation, columns, control) {}

std::vector<std::pair<ColumnId, double>> PartSearch::fractionalColumns() const {
    std::vector<std::pair<ColumnId, double>> fractional;
    const ColumnValues& values = relaxation.values();
    for (const ColumnId column : values.ids())
        if (isFractional(values[column]) && formulation.variableOf[column].valid() &&
            columns.value(column) == ArcState::free)
            fractional.emplace_back(column, values[column]);
    return fractional;
}

bool PartSearch::allDecided() const {
    return std::ranges::none_of(variables, [this](VariableId variable) { return state.isFree(variable); });
}

double PartSearch::present(VariableId variable) const {
    const auto [fromBefore, fromAfter, cover] = formulation.columnsOf[variable];
    const auto value = [this](ColumnId column) { return column.valid() ? relaxation.values()[column] : 0; };
    return value(fromBefore) + value(fromAfter);
}

void PartSearch::recordLeaf() {
    incumbents.offer(cost.of([this](VariableId variable) { return state.value(variable) == ArcState::in; }),
                     state.assignment());
}

} // namespace qm
