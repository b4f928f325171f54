/// \file Which lines can be cracked, and how often (docs/METHOD.md#cracks).
#pragma once

#include "enumerate/state/problem.h"
#include "enumerate/state/sparse_index.h"

#include <vector>

namespace qm {

struct CrackNodes {
    IdVector<CrackNodeId, CrackNode> nodes;
    SparseIndex<LineId, CrackNodeId> nodeOf; ///< of the lines that can be cracked
};

/// Fixed crossings of fixed lines use up their capacity once and for all. Looks at the given lines, and those
/// that such crossings join with them.
/// \param chainOf  of lines their chain, the first if there are two
/// \param lines    that nodes are asked of, ascending
[[nodiscard]] CrackNodes crackNodes(const ProblemInput& input, const IdVector<ChainId, Chain>& chains,
                                    const SparseIndex<LineId, ChainId>& chainOf,
                                    const std::vector<LineId>& lines);

} // namespace qm
