/// \file Sharp edges inside segments, which a smooth surface would round off (docs/METHOD.md#pruning).
#pragma once

#include "prune/added_tracks.h"

namespace qm {

/// Adds tracks through such edges: those that are too sharp for a round part, if rounding would move the
/// surface visibly, and others, if it would move it much and the line that they are on is not round.
/// Closed components in which no track starts stay as they are.
void cutAlongRoundedEdges(const PrunedMesh& pruned, AddedTracks& tracks);

} // namespace qm
