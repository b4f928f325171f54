/// \file From a layout to its surfaces: the one call that does everything (docs/METHOD.md#smooth-fit).
#pragma once

#include "base/control.h"
#include "base/infinity.h"
#include "base/length.h"
#include "bspline/reference/scan/triangle_surface.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"
#include "mesh/dihedral.h"

#include <string>
#include <vector>

namespace qm {

enum class Fit {
    smooth,     ///< watertight, G1 across smooth borders, with few control points within a tolerance
    interpolate ///< the paper's: through every vertex, every patch by itself
};

struct FitOptions {
    Fit fit = Fit::smooth;
    /// Largest distance from the reference; used by Fit::smooth only.
    Length tolerance{0.1, true};
    /// A border edge is smooth if its dihedral angle is at most this, in radians.
    double rho = defaultRho;
    /// Seconds for Fit::smooth, which ends then as if `control.stopRequested`; what is measured comes on top.
    double timeLimit = infinity;
};

/// One patch for every segment, and how far they are from the reference and from the mesh. The reference is
/// the smooth surface through the mesh's vertices, but for those of folded quads and within plane parts (see
/// `bridgedMesh` and `evenedMesh`), or a scan. If `control.stopRequested`, the smooth fit ends with the best
/// surfaces that it has, which may be far from what is allowed, and measures them.
/// \param dihedralAngles  of every edge, in radians, by edge index
/// \param scan  null if there is none
/// \throw Error  if an option is out of range, or the scan is not of this mesh
[[nodiscard]] Surfaces fitSurfaces(const QuadMesh& mesh, const Layout& layout,
                                   const std::vector<double>& dihedralAngles, const FitOptions& options,
                                   const TriangleSurface* scan = nullptr, const Control& control = {});

/// The largest distance from the reference that is allowed, in the mesh's unit: the tolerance, and of a scan
/// what is left of its noise.
[[nodiscard]] double allowedDistance(const Surfaces& surfaces, const FitOptions& options, double diagonal);

/// Where surfaces are farther from the reference than the tolerance, and by how much, as a sentence; empty if
/// they keep it, or nobody asked for one.
[[nodiscard]] std::string missedTolerance(const Surfaces& surfaces, const FitOptions& options);

} // namespace qm
