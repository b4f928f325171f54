/// \file A reference for the exact search: the same problem in a direct formulation, solved by CBC.
#pragma once

#include "enumerate/state/problem.h"

namespace qm::bench {

struct PlainCbcResult {
    bool found = false;
    bool proven = false;
    double cost = 0; ///< G_T, if a graph was found
    double lowerBound = 0;
};

/// Solves a formulation with one binary column for every particle and arc that it can walk, rows for rules 1
/// to 3 (docs/METHOD.md#arc-rules) and A2 in place of rule 4, with CBC's default settings.
/// \param problem  of a whole mesh: no open junctions, no fixed arcs except those of rule 1
[[nodiscard]] PlainCbcResult solveWithPlainCbc(const Problem& problem, double seconds);

} // namespace qm::bench
