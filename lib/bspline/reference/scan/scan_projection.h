/// \file Projects points of a surface onto a scan.
#pragma once

#include "bspline/reference/lattice/lattice_normals.h"
#include "bspline/reference/scan/triangle_surface.h"

#include <optional>

namespace qm {

/// The vector from a point of the surface to the scan, if it was found there.
using Displacement = std::optional<Eigen::Vector3d>;

struct ScanProjection {
    std::vector<Displacement> displacements; ///< by lattice point; none at sharp points
    double maxDistance = 0;                  ///< the largest distance at which the scan was looked for
};

/// The largest distance to look at, and the smallest if the distances themselves determine it.
struct ScanReach {
    double min = 0;
    double max = 0;
};

/// Parts of the scan whose normals differ by more than 60 degrees from the surface's do not count.
[[nodiscard]] ScanProjection projectOntoScan(const LatticeNormals& lattice, const TriangleSurface& scan,
                                             const ScanReach& reach, unsigned jobs);

} // namespace qm
