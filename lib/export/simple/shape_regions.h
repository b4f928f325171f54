/// \file Patches that hang together and lie on one plane, cylinder, cone, sphere or torus.
#pragma once

#include "export/simple/patch_cloud.h"
#include "export/simple/shape_agreement.h"
#include "export/simple/simple_shape.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// Patches and the surface that all of them lie on.
struct ShapeRegion {
    PatchCloud cloud;  ///< of all patches, or of those that the shape was found from
    SimpleShape shape; ///< in the cloud's frame
    std::vector<std::size_t> patches;
    int side = 1;         ///< -1 if the shape's normals point the other way than the patches'
    double tolerance = 0; ///< the smallest of the patches'
    double area = 0;      ///< of all patches
    double looseness = 0; ///< largest distance of the cloud's points from the shape; not scaled
    bool isExact = false; ///< the plane of a patch that is exactly that
    WaveLimits limits{};  ///< between the patches and the shape
};

/// What regions grow over.
struct ShapePatches {
    std::vector<PatchCloud> clouds;
    std::vector<double> tolerances; ///< by patch; 0: is in no region
    /// By patch: the plane that it is exactly, in the mesh's unit. It is the only patch of its region that
    /// may have a tolerance of 0.
    std::vector<std::optional<SimpleShape>> planes;
    std::vector<std::vector<std::size_t>> neighbours; ///< by patch: those that it meets smoothly
};

/// Divides patches into regions. All patches that hang together between creases are one, if one surface
/// passes them. Of every kind of surface, regions grow from the largest patches over all neighbours that lie
/// on the same surface. Where regions of several kinds overlap, the one with the largest area keeps the
/// patches, a simpler kind before a slightly larger one; so a patch that could be anything is what its
/// neighbours are. Patches that lie on nothing are in no region. Near linear in the number of patches.
[[nodiscard]] std::vector<ShapeRegion> shapeRegions(const ShapePatches& patches);

} // namespace qm
