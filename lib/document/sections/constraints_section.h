/// \file The section `constraints`, which is written by people.
#pragma once

#include "basecomplex/base_complex.h"
#include "document/json/json_place.h"
#include "layout/constraints.h"

namespace qm {

/// Every edge must lie on a separatrix; required edges on the mesh boundary are ignored, because they are
/// patch boundaries anyway. No edge may be both required and forbidden, or have two weights.
/// \param complex  with the feature seeds
[[nodiscard]] Constraints readConstraints(const QuadMesh& mesh, const BaseComplex& complex,
                                          const JsonPlace& section);

} // namespace qm
