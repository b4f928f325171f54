/// \file Prepares what surfaces are fitted to, in the same way for fits, pages and pictures.
#pragma once

#include "bspline/network/smooth_network.h"
#include "bspline/reference/fit_target.h"

#include <optional>

namespace qm {

struct FitReference {
    std::optional<QuadMesh> bridged; ///< replaces the mesh if folded quads were bridged
    SmoothNetwork network;
    FitTarget target;
};

struct ReferenceOptions {
    double rho = 0;      ///< a border edge of a larger dihedral angle is a crease; radians
    bool bridges = true; ///< whether to bridge folded quads (see `bridgedMesh`)
};

/// \param dihedralAngles  by edge index, radians
/// \param scan  null if there is none
/// \throw Error  if the scan is nowhere near the mesh
[[nodiscard]] FitReference fitReference(const QuadMesh& mesh, const Layout& layout,
                                        const std::vector<double>& dihedralAngles,
                                        const ReferenceOptions& options, const TriangleSurface* scan,
                                        unsigned jobs);

} // namespace qm
