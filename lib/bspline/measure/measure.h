/// \file All measurements of finished surfaces, in one call.
#pragma once

#include "bspline/measure/paired_surfaces.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <vector>

namespace qm {

/// Largest distances are too large by at most this share of themselves,
constexpr double measureClosing = 0.02;
/// or are below this share of the bounding box's diagonal, and within the tolerance.
constexpr double measureNegligible = 1e-5;

/// What is measured; references are by patch, like the patches.
struct MeasuredSurfaces {
    const QuadMesh& mesh;
    const Layout& layout;
    const std::vector<Patch>& patches;
    const std::vector<ReferenceGrid>& references;
};

struct PatchMeasurement {
    Deviation deviation;           ///< borders count for both neighbours
    double lowerBound = 0;         ///< the largest distance from the reference that was found at a point
    LayoutPlace farthest;          ///< where it was found
    std::vector<Parameters> folds; ///< a place in every piece that may be folded
};

struct Measurement {
    PatchMeasurement ofAll; ///< without places of folds
    std::vector<PatchMeasurement> ofPatch;
};

/// Measures the deviations from the reference, from the quads and from the vertices, and borders, inner
/// lines, folds and fairness. Linear in the mesh; most of the time is that of `certifiedDeviations`.
/// \param isSmooth    by edge: whether normals are compared across it
/// \param negligible  distances below this need not be told apart
[[nodiscard]] Measurement measureSurfaces(const MeasuredSurfaces& surfaces, const std::vector<bool>& isSmooth,
                                          double negligible, unsigned jobs);

} // namespace qm
