/// \file Whether a surface turns over above a quad of the mesh (docs/METHOD.md#measuring).
#pragma once

#include "check/mesh/angles.h"
#include "check/surfaces/bilinear_quad.h"
#include "check/surfaces/spline.h"

#include <cstddef>
#include <vector>

namespace qm::check {

/// What a patch is at the samples above one quad.
struct QuadSamples {
    const std::vector<SurfacePoint>& points; ///< of a row of quads, row by row of the lattice
    std::size_t width = 0;                   ///< of a row of the lattice
    std::size_t first = 0;                   ///< of the quad's samples in the first row

    /// \param i, j  0 to `samplesPerEdge`, along the quad's first side and along its last
    [[nodiscard]] const SurfacePoint& at(int i, int j) const;
};

/// Whether the surface's normal looks away from the quad's in the middle, or turns over from one sample to
/// the next. The corners of the quad are left out: where its sides are almost one line, a patch has hardly a
/// normal there. Nothing is asked of a quad with a corner above 165 degrees: all surfaces through its sides
/// turn over beside it.
[[nodiscard]] bool isFolded(const BilinearQuad& quad, const QuadSamples& samples);

/// Whether a quad lies against one beside it, so that no surface should follow both.
[[nodiscard]] bool liesAgainstNeighbour(const CheckedMesh& mesh, const Neighbourhoods& around,
                                        const Angles& angles, int face);

} // namespace qm::check
