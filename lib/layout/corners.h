/// \file Corners of segments (docs/METHOD.md#cost): corners of faces with a track or the mesh boundary on
/// both sides.
#pragma once

#include "base/id_vector.h"
#include "layout/motorcycle_graph.h"
#include "mesh/sub_meshes.h"

#include <vector>

namespace qm {

/// Counts corners of segments in graphs of sub-meshes.
class Corners {
public:
    /// Time is linear in the mesh. Both arguments must outlive this.
    Corners(const QuadMesh& mesh, const SubMeshes& subMeshes);

    /// The number of corners that all graphs of a sub-mesh have: those at its extraordinary vertices and at
    /// convex vertices of its boundary.
    [[nodiscard]] std::size_t fixed(SubMeshId subMesh) const { return fixed_[subMesh]; }

    /// The number of all corners: the fixed ones, those at the other vertices of the sub-mesh, and two for
    /// every track that ends on the mesh boundary, even beyond the cut. Time is linear in the tracks.
    [[nodiscard]] std::size_t between(const std::vector<Track>& tracks, SubMeshId subMesh) const;

private:
    const QuadMesh& mesh_;
    const SubMeshes& subMeshes_;
    IdVector<SubMeshId, std::size_t> fixed_;
};

} // namespace qm
