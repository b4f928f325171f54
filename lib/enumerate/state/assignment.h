/// \file A value for every variable of a search problem, and the graph that the values describe.
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

/// The value, 0 or 1, of every variable and of the two constants.
using Assignment = IdVector<VariableId, signed char>;

/// The cost of all variables that are in, and of the corners of segments at crossings.
[[nodiscard]] double costOf(const Problem& problem, const Assignment& assignment);

/// The assignment that describes a graph.
[[nodiscard]] Assignment assignmentOf(const Problem& problem, const PresentArcs& present);

/// The arcs that are present in the graph and out in the assignment, or the other way round.
[[nodiscard]] std::vector<ArcId> differences(const Problem& problem, const Assignment& assignment,
                                             const PresentArcs& present);

/// Overwrites the arcs of all variables with the values of an assignment.
void apply(const Problem& problem, const Assignment& assignment, PresentArcs& present);

/// The value of every arc, such as in a relaxed solution: that of its variable; 0 if it is not free.
/// \return empty if there are no values
[[nodiscard]] IdVector<ArcId, double> arcValues(const Problem& problem,
                                                const IdVector<VariableId, double>& values, std::size_t arcs);

} // namespace qm
