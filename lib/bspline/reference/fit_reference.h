/// \file Prepares what surfaces are fitted to, in the same way for fits, pages and pictures.
#pragma once

#include "bspline/network/smooth_network.h"
#include "bspline/reference/lattice/fit_target.h"
#include "bspline/reference/scan/triangle_surface.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// Meshes of more faces than this are sampled less finely, as their edges are short.
constexpr std::size_t veryManyFaces = 300'000;

struct FitReference {
    std::optional<QuadMesh> improved; ///< replaces the mesh if vertices were moved
    SmoothNetwork network;
    FitTarget target;

    /// The mesh that network and target are of.
    /// \param mesh  what they were made from
    [[nodiscard]] const QuadMesh& meshOf(const QuadMesh& mesh) const { return improved ? *improved : mesh; }
};

struct ReferenceOptions {
    double rho = 0; ///< a border edge of a larger dihedral angle is a crease; radians
    /// Whether vertices of folded quads and of plane parts are moved (see `bridgedMesh` and `evenedMesh`).
    bool improves = true;
};

/// The target is the smooth surface through the mesh's vertices, or, with a scan, the scan as seen from that
/// surface, without its noise. The lattices have four steps per mesh edge; two for very many faces.
/// \param dihedralAngles  by edge index, radians
/// \param scan  null if there is none
/// \throw Error  if the scan is nowhere near the mesh
[[nodiscard]] FitReference fitReference(const QuadMesh& mesh, const Layout& layout,
                                        const std::vector<double>& dihedralAngles,
                                        const ReferenceOptions& options, const TriangleSurface* scan,
                                        unsigned jobs);

} // namespace qm
