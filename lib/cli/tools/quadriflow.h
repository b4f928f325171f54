/// \file Remeshing triangles into quads by QuadriFlow, as included in Blender.
#pragma once

#include "mesh/quad_mesh.h"
#include "mesh/soup/repair.h"
#include "mesh/triangles/triangles.h"
#include "remesh/mismatch.h"

namespace qm {

struct RemeshOptions {
    int quads = 5000;          ///< approximate number of quads
    bool preserveSharp = true; ///< whether edges of the mesh follow sharp edges of the scan
    int seed = 0;              ///< another seed gives another mesh
    bool draw = true;          ///< whether vertices are drawn to the scan (see `drawToScan`)
};

struct Remeshed {
    QuadMesh mesh;
    RepairReport repair;       ///< repairs of QuadriFlow's result
    std::size_t loops = 0;     ///< boundary loops of the mesh
    std::size_t scanLoops = 0; ///< boundary loops of the scan
    RemeshOptions used;        ///< with which it was made
    Mismatch mismatch;         ///< with the scan
};

/// Blender works on the scan moved to the origin, because it computes in single precision, and scaled. If the
/// result is no quad mesh, or has other boundary loops than the scan, the next seeds are tried, three in
/// total, without regard to sharp edges once one did not end; if no result is a quad mesh, an open scan is
/// tried once more without holding edges to its boundary. The first of the best results is returned, with
/// small holes closed where the scan has none.
/// \param scan  a manifold (see `repairTriangles`)
/// \throw Error  if Blender is not installed, or no result is a quad mesh
[[nodiscard]] Remeshed remeshWithBlender(const Triangles& scan, const RemeshOptions& options, unsigned jobs);

} // namespace qm
