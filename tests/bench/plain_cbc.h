/// \file The yardstick for the exact search: the same problem written down plainly, for CBC as it comes.
#pragma once

#include "enumerate/state/problem.h"

namespace qm::bench {

struct PlainCbcResult {
    bool found = false;
    bool proven = false;
    double cost = 0; ///< G_T, if found
    double lowerBound = 0;
};

/// One binary column for every particle and arc that it can walk, rules 1 to 3 (docs/METHOD.md#arc-rules) row
/// by row and A2 in place of rule 4; default settings.
/// \param problem  of a whole mesh: no open junctions, no fixed arcs but those of rule 1
[[nodiscard]] PlainCbcResult solveWithPlainCbc(const Problem& problem, double seconds);

} // namespace qm::bench
