/// \file Which lines can be cracked, and how often (docs/METHOD.md#cracks).
#pragma once

#include "base/sparse_id_vector.h"
#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

struct CrackNodes {
    IdVector<CrackNodeId, CrackNode> nodes;
    SparseIdVector<LineId, CrackNodeId> nodeOf; ///< of the lines that can be cracked
};

/// Finds the crack nodes of the given lines. Fixed lines that cross at fixed crossings share a node, whose
/// capacity these crossings have reduced already.
/// \param chainOf  the chain of every line that has one; the first if a line has two
/// \param lines    the lines whose nodes are needed, ascending
[[nodiscard]] CrackNodes crackNodes(const ProblemInput& input, const IdVector<ChainId, Chain>& chains,
                                    const SparseIdVector<LineId, ChainId>& chainOf,
                                    const std::vector<LineId>& lines);

} // namespace qm
