/// \file Where a scan is, seen from a surface: what patches are fitted to if there is a scan.
#pragma once

#include "bspline/reference/reference_grid.h"
#include "bspline/reference/triangle_surface.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <numbers>
#include <vector>

namespace qm {

struct ScanOptions {
    /// What is farther from the surface is not taken for it. 0: four times as far as nine in ten lattice
    /// points are from the scan, at least a lattice step and at most two mesh edges.
    double maxDistance = 0;
    /// Radians; where the normals of surface and scan differ by more, the scan shows something else.
    double maxAngle = std::numbers::pi / 3;
};

struct ScanReference {
    std::vector<ReferenceGrid> grids;         ///< the targets
    std::vector<std::vector<double>> weights; ///< by grid and point: up to 1; less where they are guessed
    double coverage = 0;                      ///< share of the lattice points for which the scan shows one
    double maxDistance = 0;                   ///< that was used
    double noise = 0; ///< standard deviation of the scan from a smooth surface, as its targets show it
};

/// For every lattice point of a surface a point of the scan: the nearest on its normal or, failing that, the
/// nearest at all. It shows none where it has a hole or ends, is too far away, or has another normal. A point
/// that jumps out from those around it weighs less or nothing: the weight is Tukey's biweight of its distance
/// from their median. What is missing then is filled in (`fillGaps`), and the noise smoothed. At sharp edges
/// of the surface the sides are carried on and meet, so that edges which the scan has rounded or frayed stay
/// sharp. Targets over which the surface would fold are dropped (`dropFolded`). A scan whose triangles are
/// turned inside out, or this way and that, will do as well.
/// \param surface  by segment, all with the same steps and equal points on common borders; `limitSurface` to
/// begin with, afterwards maybe what was fitted, to project on from there
/// \param jobs  threads; the result does not depend on them
[[nodiscard]] ScanReference scanReference(const QuadMesh& mesh, const Layout& layout,
                                          const std::vector<ReferenceGrid>& surface,
                                          const TriangleSurface& scan, const ScanOptions& options,
                                          unsigned jobs);

} // namespace qm
