/// \file What qm-prune says about its proofs.
#pragma once

#include "cli/tool.h"
#include "prune/prune.h"

namespace qm {

/// Warns of layouts that are not proven to be the best, and notes all of a front.
void reportProofs(const Tool& tool, const PruneOptions& options, const PruneResult& pruned);

} // namespace qm
