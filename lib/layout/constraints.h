/// \file What a person demands of the graphs: "this edge must be a patch boundary", "none here".
#pragma once

#include "mesh/quad_mesh.h"

#include <utility>
#include <vector>

namespace qm {

/// Mesh edges by kind. An edge on no separatrix can be neither required nor forbidden, and has no weight.
struct Constraints {
    std::vector<EdgeId> required;
    std::vector<EdgeId> forbidden;
    std::vector<std::pair<EdgeId, double>> weights; ///< what an edge costs beyond the other terms
};

} // namespace qm
