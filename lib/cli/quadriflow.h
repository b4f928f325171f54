/// \file QuadriFlow, as it stands in Blender: quads from triangles.
#pragma once

#include "mesh/quad_mesh.h"
#include "mesh/repair.h"
#include "mesh/triangles.h"

namespace qm {

struct RemeshOptions {
    int quads = 5000;          ///< about so many
    bool preserveSharp = true; ///< edges of the mesh follow the sharp edges of the scan
    int seed = 0;              ///< another one, another mesh
    bool draw = true;          ///< the vertices are drawn to the scan (see `drawToScan`)
};

struct Remeshed {
    QuadMesh mesh;
    RepairReport repair;       ///< what had to be mended of QuadriFlow's result
    std::size_t loops = 0;     ///< boundary loops of the mesh
    std::size_t scanLoops = 0; ///< those of the scan
    int seed = 0;              ///< that it was made with
};

/// Blender works on the scan moved and scaled to unit size, as it computes in single precision. Where the
/// result is no quad mesh, or has other boundary loops than the scan, the next seeds are tried, three in all,
/// and the first of the best results is taken.
/// \throw Error  if there is no Blender, the scan is no manifold, or no result is a quad mesh
[[nodiscard]] Remeshed remeshWithBlender(const Triangles& scan, const RemeshOptions& options, unsigned jobs);

} // namespace qm
