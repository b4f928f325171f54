/// \file Corners of sharp edges inside a side of a segment (docs/METHOD.md#pruning, smoothness).
#pragma once

#include "layout/layout.h"
#include "prune/pruned_mesh.h"

#include <vector>

namespace qm {

/// Makes such places corners: where a track ends on a line of two sharp edges that turns by more than
/// `maxTurn`, another track goes straight on as far as the next border. Otherwise the side of the segment
/// beyond passes through the corner, and no smooth surface has such a side.
/// \param layout     as made by `buildLayout`; transversals are no borders here, as they are drawn anew
/// \param maxTurn    degrees; at 180 nothing turns by more
/// \param forbidden  edges over which no track goes on
[[nodiscard]] Layout cutTurnedSides(const PrunedMesh& pruned, const Layout& layout, double maxTurn,
                                    const std::vector<EdgeId>& forbidden = {});

} // namespace qm
