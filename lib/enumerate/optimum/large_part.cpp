#include "enumerate/optimum/large_part.h"

#include "enumerate/optimum/formulation.h"
#include "program/gradient_relaxation.h"

#include <utility>

namespace qm {
namespace {

/// A bound that is nearer by this share of it costs more time than improving it by integrality does.
constexpr double tolerance = 5e-3;

} // namespace

LargePart relaxLargePart(const SearchState& state, const std::vector<VariableId>& variables,
                         const Control& control) {
    const Formulation formulation = formulate(state, variables);
    LargePart part;
    part.relaxed.constant = formulation.constant;
    part.relaxed.program = {formulation.costs, formulation.rows};
    GradientOptions options;
    options.tolerance = tolerance;
    NearOptimum found = relaxByGradients(part.relaxed.program, options, control);
    part.lowerBound = formulation.constant + found.lowerBound;
    part.relaxed.values = std::move(found.values);
    part.relaxed.duals = std::move(found.duals);
    for (const VariableId variable : variables) {
        const auto& [fromBefore, fromAfter] = formulation.columnsOf[variable];
        double present = 0;
        for (const ColumnId column : {fromBefore, fromAfter})
            if (column.valid()) present += part.relaxed.values[column];
        part.present.push_back(present);
    }
    return part;
}

} // namespace qm
