/// \file From points of a surface to points of a scan.
#pragma once

#include "bspline/reference/lattice_normals.h"
#include "bspline/reference/triangle_surface.h"

#include <optional>

namespace qm {

/// By what a point of the surface is moved to lie on the scan.
using Displacement = std::optional<Eigen::Vector3d>;

struct ScanProjection {
    std::vector<Displacement> displacements; ///< by lattice point; none for sharp ones
    double maxDistance = 0;                  ///< that was used
};

/// How far to look at most, and how far at least where the distances themselves decide.
struct ScanReach {
    double min = 0;
    double max = 0;
};

/// \param minCosine  of the angle between the normals of surface and scan
[[nodiscard]] ScanProjection projectOntoScan(const LatticeNormals& lattice, const TriangleSurface& scan,
                                             const ScanReach& reach, double minCosine, unsigned jobs);

} // namespace qm
