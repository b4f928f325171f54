/// \file Segments without corners, as columns of the pruning program (docs/METHOD.md#pruning-program).
///
/// The number of segments is a quarter of the number of corners only if every segment has four. An annulus
/// has none, but becomes one segment when a transversal cuts it, so a column counts four corners for it. A
/// component of regular vertices only, a torus or a tube, has no source; it gets a line when no track is left
/// in it.
#pragma once

#include "prune/grid_program.h"

namespace qm {

/// Adds columns that count annuli.
void addAnnuli(const QuadMesh& mesh, GridProgram& grids);

/// Adds one column for every component without a source: 1 if the component gets its line (see `seedLine`),
/// because no arc is in.
void addSeedLines(const PrunedMesh& pruned, GridProgram& grids);

} // namespace qm
