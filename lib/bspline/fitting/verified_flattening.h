/// \file Moves plane patches into their planes, except where that would break the tolerance.
#pragma once

#include "bspline/fitting/fit_problem.h"
#include "bspline/fitting/fit_round.h"
#include "bspline/fitting/planes/flat_patches.h"

#include <optional>
#include <vector>

namespace qm {

/// Flattens the patches of a round (see `flatten`) and verifies them anew. The planes of patches that this
/// pushes beyond the tolerance are dropped, with those of their neighbours, until none is; if some always
/// are, the round stays as it is.
/// \param planes  by patch
/// \param round   with verified distances
void flattenWhereKept(const FitProblem& problem, std::vector<std::optional<FlatPatch>> planes,
                      FitRound& round, unsigned jobs);

} // namespace qm
