/// \file Constraints on graphs by a person: edges that must be patch boundaries, or must not be.
#pragma once

#include "layout/motorcycle_graph.h"
#include "mesh/quad_mesh.h"

#include <span>
#include <utility>
#include <vector>

namespace qm {

/// Mesh edges by kind of constraint. An edge that lies on no separatrix can be neither required nor
/// forbidden, and its weight has no effect.
struct Constraints {
    std::vector<EdgeId> required;
    std::vector<EdgeId> forbidden;
    std::vector<std::pair<EdgeId, double>> weights; ///< added to the cost of each edge by the term *custom*
};

/// Whether all required edges lie on the tracks or on the mesh boundary, and no forbidden edge lies on a
/// track.
[[nodiscard]] bool obeyConstraints(const QuadMesh& mesh, std::span<const Track> tracks,
                                   const Constraints& constraints);

} // namespace qm
