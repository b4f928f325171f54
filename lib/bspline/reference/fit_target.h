/// \file The reference that surfaces are fitted to and measured from.
#pragma once

#include "bspline/network/smooth_network.h"
#include "bspline/reference/reference_grid.h"
#include "bspline/reference/triangle_surface.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Meshes of more faces than this are sampled less finely, as their edges are short.
constexpr std::size_t veryManyFaces = 300'000;

struct FitTarget {
    std::vector<ReferenceGrid> grids{}; ///< by segment
    /// By grid and point: at most 1, less where the scan has nothing and the point is guessed; empty if all
    /// are 1.
    std::vector<std::vector<double>> weights{};
    double coverage = 1;    ///< share of the points for which the scan has one
    double noise = 0;       ///< standard deviation of the scan from a smooth surface, estimated
    double maxDistance = 0; ///< farther parts of the scan are ignored
};

/// The smooth surface through the mesh's vertices, or, with a scan, the scan as seen from that surface,
/// without its noise. The lattices have four steps per mesh edge; two for very many faces.
/// \param scan  null if there is none
/// \throw Error  if the scan is nowhere near the mesh
[[nodiscard]] FitTarget fitTarget(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
                                  const TriangleSurface* scan, unsigned jobs);

} // namespace qm
