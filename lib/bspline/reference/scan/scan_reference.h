/// \file The scan as seen from a surface, which patches are fitted to.
#pragma once

#include "bspline/reference/lattice/fit_target.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "bspline/reference/scan/triangle_surface.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// Finds a point of the scan for every lattice point of a surface: the nearest on its normal or, failing
/// that, the nearest of all. There is none in holes and beyond the ends of the scan, where it is farther away
/// than four times the distance below which nine in ten lattice points are, but at least one lattice step and
/// at most two mesh edges, and where its normal differs by more than 60 degrees. Each point is weighted by
/// Tukey's biweight of its distance from the median of those around it, so that outliers weigh less or
/// nothing. Missing points are filled in (`fillGaps`), and the noise is smoothed. At sharp edges of the
/// surface the sides are extended until they meet, so that edges which the scan has rounded or frayed stay
/// sharp. Targets over which the surface would fold are dropped (`dropFolded`). The triangles of the scan
/// need not be oriented consistently.
/// \param surface  by segment, all with the same steps and equal points on common borders: `limitSurface`
/// \param jobs     threads; the result does not depend on their number
[[nodiscard]] FitTarget scanReference(const QuadMesh& mesh, const Layout& layout,
                                      const std::vector<ReferenceGrid>& surface, const TriangleSurface& scan,
                                      unsigned jobs);

} // namespace qm
