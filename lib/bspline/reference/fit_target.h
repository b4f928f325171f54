/// \file What surfaces are fitted to and measured from.
#pragma once

#include "bspline/network/smooth_network.h"
#include "bspline/reference/reference_grid.h"
#include "bspline/reference/triangle_surface.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Faces from which on a mesh is sampled less finely, as its edges are short.
constexpr std::size_t veryManyFaces = 300'000;

struct FitTarget {
    std::vector<ReferenceGrid> grids;         ///< of every segment, in their order
    std::vector<std::vector<double>> weights; ///< of the points of every grid; empty if all are 1
    double coverage = 1;                      ///< by the scan: share of the points
    double noise = 0;                         ///< of the scan: standard deviation
    double maxDistance = 0;                   ///< at which the scan is still looked for
};

/// The smooth surface through the mesh's vertices; or, with a scan, where the scan is seen from it, without
/// the scan's noise. The lattices have four steps a mesh edge; with very many faces, two.
/// \param scan  null if there is none
/// \throw Error  if the scan is nowhere near the mesh
[[nodiscard]] FitTarget fitTarget(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
                                  const TriangleSurface* scan, unsigned jobs);

} // namespace qm
