/// \file What is found out about a part that is too large for the simplex method
/// (docs/METHOD.md#large-relaxations).
#pragma once

#include "base/control.h"
#include "enumerate/state/search_state.h"
#include "program/decomposition_bound.h"

#include <vector>

namespace qm {

struct LargePart {
    RelaxedProgram relaxed;
    double lowerBound = 0;       ///< of the cost of its variables
    std::vector<double> present; ///< relaxed values of its variables, in their order
};

/// \param variables  the free variables of an independent part
/// \return what is known when `control.stopRequested`
[[nodiscard]] LargePart relaxLargePart(const SearchState& state, const std::vector<VariableId>& variables,
                                       const Control& control);

} // namespace qm
