/// \file The corners of the segments between tracks (docs/METHOD.md#cost): corners of faces that have a track
/// or the mesh boundary on both sides.
#pragma once

#include "base/at.h"
#include "layout/motorcycle_graph.h"

#include <vector>

namespace qm {

/// Counts them in graphs of sub-meshes.
class Corners {
public:
    /// Takes time linear in the mesh.
    /// \param labels     sub-mesh of every vertex; empty if there is only one
    /// \param subMeshes  how many there are
    Corners(const QuadMesh& mesh, const std::vector<int>& labels, int subMeshes);

    /// Those that all graphs of a sub-mesh have: at its extraordinary vertices and the convex ones of its
    /// boundary.
    [[nodiscard]] std::size_t sure(int subMesh) const { return sure_[at(subMesh)]; }

    /// The sure ones, those at the other vertices of the sub-mesh, and two where a track ends on the mesh
    /// boundary, be it past the cut. Takes time linear in the tracks.
    [[nodiscard]] std::size_t between(const std::vector<Track>& tracks, int subMesh) const;

private:
    [[nodiscard]] bool isIn(VertexId vertex, int subMesh) const;

    const QuadMesh& mesh_;
    const std::vector<int>& labels_;
    std::vector<std::size_t> sure_;
};

} // namespace qm
