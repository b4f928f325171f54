/// \file Messages of qm-prune about its proofs.
#pragma once

#include "cli/tool.h"
#include "prune/prune.h"

namespace qm {

/// Warns of layouts that are not proven optimal, and notes every layout of a front.
void reportProofs(const Tool& tool, const PruneOptions& options, const PruneResult& pruned);

} // namespace qm
