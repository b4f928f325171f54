/// \file What has to hold so that quads and scan come closer to one another: squared distances from tangent
/// planes (docs/METHOD.md#pottmann-2002).
#pragma once

#include "bspline/reference/scan/triangle_surface.h"
#include "mesh/quad_mesh.h"
#include "remesh/surface_samples.h"

#include <array>
#include <vector>

namespace qm {

/// A place of the quads, a weighted mean of vertices, should move so far along a direction.
struct ScanEquation {
    std::array<int, 4> vertices{};
    std::array<double, 4> weights{};
    Point direction{0, 0, 0}; ///< of unit length
    double distance = 0;
    double weight = 0;
};

/// One for every sample of the quads, towards the plane of the nearest triangle of the scan, and one for
/// every sample of the scan, which draws the nearest place of the quads to its own plane; beyond a boundary
/// or a sharp edge straight towards one another. There are none where the other surface is more than `reach`
/// away or shows its other side, and those of far places weigh little.
/// \param reach  1.5 times the mean length of the quads' sides; at a third of it, half a mean edge, the
/// weight has fallen to a quarter
[[nodiscard]] std::vector<ScanEquation> scanEquations(const QuadMesh& mesh, const TriangleSurface& scan,
                                                      const std::vector<ScanSample>& samples, double reach,
                                                      unsigned jobs);

} // namespace qm
