/// \file Segments without corners, as columns of the pruning program (docs/METHOD.md#pruning-program).
///
/// A quarter of the corners is the number of segments only if every segment has four. An annulus has none,
/// and becomes one segment when a transversal cuts it: a column counts four corners for it. A component of
/// regular vertices, a torus or a tube, has no source, and gets a line when no border is left in it.
#pragma once

#include "prune/grid_program.h"

#include <vector>

namespace qm {

/// Adds columns that count annuli.
/// \param arcOf  of every edge; invalid where no line runs
void addAnnuli(const QuadMesh& mesh, const std::vector<ArcId>& arcOf, GridProgram& grids);

/// Adds for every component without any source a column: its line, which is there unless an arc is.
/// \param dihedralAngles  by edge, like the costs; they choose the line, see `seedLine`
void addSeedLines(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
                  const std::vector<double>& dihedralAngles, const std::vector<double>& edgeCosts,
                  GridProgram& grids);

} // namespace qm
