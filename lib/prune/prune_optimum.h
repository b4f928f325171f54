/// \file Pruning as an optimum: the cheapest layout of grids, whatever tracks it needs
/// (docs/METHOD.md#pruning-program).
#pragma once

#include "base/control.h"
#include "prune/prune.h"

namespace qm {

/// What the options ask for: greedy or optimum, with or without the front, all within the time limit.
///
/// The optimum minimises G_T + beta * segments, or G_T under a number of segments, or their number and then
/// G_T, over all arcs of the base complex. Extraordinary vertices need tracks only so that no segment has a
/// corner above 180 degrees. A front holds layouts for a range of beta, 1/16 to 64, from many segments to
/// few; none is as good as another in segments, G_T and captured sharpness together.
///
/// With the smoothness criterion, and `maxSharpTurn` below 180 degrees, tracks are added where no smooth
/// surface would do: from corners of sharp edges before anything is removed, and along sharp edges inside
/// segments afterwards; from corners of the mesh boundary before greedy pruning, after the optimum. Where the
/// number of segments is limited or minimised, none are added afterwards, and a front never counts those.
/// \param layout  the start, of the same mesh; the optimum is never worse
/// \throw Error  if it does not obey the constraints, its tracks are not made of arcs, or nothing is found
/// under a number of segments
/// \param rho  edges with larger dihedral angles count as sharp, radians
[[nodiscard]] PruneResult prune(const PrunedMesh& pruned, const Layout& layout, const PruneOptions& options,
                                double rho, const Control& control = {});

} // namespace qm
