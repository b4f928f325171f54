/// \file Moves plane patches into their planes, except where that would break the tolerance.
#pragma once

#include "bspline/fitting/fit_problem.h"
#include "bspline/fitting/fit_round.h"
#include "bspline/fitting/fit_state.h"
#include "bspline/fitting/planes/flat_patches.h"

#include <optional>
#include <vector>

namespace qm {

/// Drops the planes of patches that planes have spoiled, or if none of these has one, the planes nearest to
/// them.
/// \param planes  by patch
/// \return whether any patch is spoiled
bool dropPlanes(const std::vector<Stretch>& stretches, std::vector<bool> isSpoiled,
                std::vector<std::optional<FlatPatch>>& planes);

/// Flattens the patches of a round (see `FitState::flatten`) and verifies them anew. Planes are dropped where
/// this folds patches or pushes them beyond the tolerance, until it does so nowhere; if it always does, the
/// round stays as it is.
/// \param planes  by patch; those dropped are gone
/// \param state   is at any round afterwards
/// \param round   with verified distances
void flattenWhereKept(const Verification& verify, int slides, std::vector<std::optional<FlatPatch>>& planes,
                      FitState& state, FitRound& round);

} // namespace qm
