/// \file Corners of sharp edges, or of the mesh boundary, in a side of a segment (docs/METHOD.md#pruning).
#pragma once

#include "prune/added_tracks.h"

namespace qm {

/// Makes such places corners: where a track ends on a line of two sharp edges that turns by more than
/// `maxTurn`, another track goes straight on as far as the next border. Otherwise the side of the segment
/// beyond passes through the corner, and no smooth surface has such a side.
/// \param maxTurn  degrees; at 180 nothing turns by more
void cutTurnedSides(const PrunedMesh& pruned, double maxTurn, AddedTracks& tracks);

/// The same where the mesh boundary turns at a vertex of two quads: a track goes from there to the next
/// border. A boundary that turns about as much at its next vertices is round, and stays.
void cutTurnedOutlines(const QuadMesh& mesh, double maxTurn, AddedTracks& tracks);

} // namespace qm
