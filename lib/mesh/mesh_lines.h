/// \file All mesh lines: maximal paths that go straight on (docs/METHOD.md#words).
#pragma once

#include "mesh/quad_mesh.h"

#include <functional>
#include <vector>

namespace qm {

/// A maximal straight path over interior edges. Open lines end at extraordinary or boundary vertices; closed
/// lines contain neither.
struct MeshLine {
    std::vector<HalfedgeId> halfedges;
    bool closed = false;
};

/// What goes straight on from a halfedge over interior edges: the rest of its line, or all of a closed one.
[[nodiscard]] MeshLine straightFrom(const QuadMesh& mesh, HalfedgeId start);

/// Visits every line once, and so every interior edge: first open lines, by their first vertex, then closed
/// lines, by their lowest edge. Linear in the mesh.
void forEachMeshLine(const QuadMesh& mesh, const std::function<void(const MeshLine&)>& visit);

} // namespace qm
