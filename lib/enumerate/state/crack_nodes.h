/// \file Which lines can be cracked, and how often (docs/METHOD.md#cracks).
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

struct CrackNodes {
    std::vector<CrackNode> nodes;
    std::vector<int> nodeOf; ///< of every line; -1 if it cannot be cracked
};

/// Crossings between two fixed lines use up cracks once and for all.
/// \param chainOf  of every line its chain, the first if there are two; -1 if it has none
[[nodiscard]] CrackNodes crackNodes(const ProblemInput& input, const std::vector<Chain>& chains,
                                    const std::vector<int>& chainOf);

} // namespace qm
