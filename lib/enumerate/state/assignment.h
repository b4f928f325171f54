/// \file Values for the variables of a search problem, and the arcs they stand for.
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

/// A value for every variable and both constants, 0 or 1.
using Assignment = IdVector<VariableId, signed char>;

/// The cost of the variables that are in and of the corners at crossings.
[[nodiscard]] double costOf(const Problem& problem, const Assignment& assignment);

/// The values that variables have where these arcs are present.
[[nodiscard]] Assignment assignmentOf(const Problem& problem, const std::vector<bool>& present);

/// The arcs that are present in only one of a graph and an assignment.
[[nodiscard]] std::vector<ArcId> differences(const Problem& problem, const Assignment& assignment,
                                             const std::vector<bool>& present);

/// Writes the values of an assignment into the arcs of its variables.
void apply(const Problem& problem, const Assignment& assignment, std::vector<bool>& present);

} // namespace qm
