/// \file The sub-mesh that every vertex of a mesh belongs to (docs/METHOD.md#mesh-cut).
#pragma once

#include "base/at.h"
#include "base/id_vector.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// The sub-meshes of a mesh; by default, the whole mesh is the only one.
struct SubMeshes {
    std::vector<SubMeshId> labels; ///< of every vertex; empty if there is only one sub-mesh
    int count = 1;

    [[nodiscard]] SubMeshId of(VertexId vertex) const {
        return labels.empty() ? SubMeshId(0) : labels[at(vertex)];
    }
    [[nodiscard]] IdRange<SubMeshId> ids() const { return {SubMeshId(0), SubMeshId(count)}; }
};

} // namespace qm
