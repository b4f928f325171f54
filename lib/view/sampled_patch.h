/// \file Patches sampled for the eye.
#pragma once

#include "bspline/splines/evaluate.h"
#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// A lattice of `width` x `height` points, row by row along u; `steps` of them to every quad of the segment.
struct SampledPatch {
    std::size_t width = 0;
    std::size_t height = 0;
    std::size_t steps = 1;
    std::vector<SurfacePoint> points;
    std::vector<double> distances; ///< of the points from the mesh
};

/// The fewer quads the mesh has, the more samples for each.
/// \param patches  one for every segment
[[nodiscard]] std::vector<SampledPatch> samplePatches(const QuadMesh& mesh, const Layout& layout,
                                                      const std::vector<Patch>& patches, unsigned jobs);

} // namespace qm
