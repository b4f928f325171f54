/// \file What a person demands of the graphs: "this edge must be a patch boundary", "none here".
#pragma once

#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// Mesh edges by kind. An edge on no separatrix can be neither required nor forbidden.
struct Constraints {
    std::vector<EdgeId> required;
    std::vector<EdgeId> forbidden;
};

} // namespace qm
