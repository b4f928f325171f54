/// \file All mesh lines: maximal paths that go straight on (docs/METHOD.md#words).
#pragma once

#include "mesh/quad_mesh.h"

#include <functional>
#include <vector>

namespace qm {

/// A maximal straight path over interior edges. Open lines end at extraordinary or boundary vertices; closed
/// ones meet neither.
struct MeshLine {
    std::vector<HalfedgeId> halfedges;
    bool closed = false;
};

/// Visits every line once, and with them every interior edge: first the open ones by their first vertex, then
/// the closed ones by their lowest edge. Linear in the mesh.
void forEachMeshLine(const QuadMesh& mesh, const std::function<void(const MeshLine&)>& visit);

} // namespace qm
