/// \file The corners of the segments between tracks (docs/METHOD.md#cost): corners of faces that have a track
/// or the mesh boundary on both sides.
#pragma once

#include "base/id_vector.h"
#include "layout/motorcycle_graph.h"
#include "mesh/sub_meshes.h"

#include <vector>

namespace qm {

/// Counts them in graphs of sub-meshes.
class Corners {
public:
    /// Takes time linear in the mesh. Both arguments outlive this.
    Corners(const QuadMesh& mesh, const SubMeshes& subMeshes);

    /// Those that all graphs of a sub-mesh have: at its extraordinary vertices and the convex ones of its
    /// boundary.
    [[nodiscard]] std::size_t sure(SubMeshId subMesh) const { return sure_[subMesh]; }

    /// The sure ones, those at the other vertices of the sub-mesh, and two where a track ends on the mesh
    /// boundary, be it past the cut. Takes time linear in the tracks.
    [[nodiscard]] std::size_t between(const std::vector<Track>& tracks, SubMeshId subMesh) const;

private:
    const QuadMesh& mesh_;
    const SubMeshes& subMeshes_;
    IdVector<SubMeshId, std::size_t> sure_;
};

} // namespace qm
