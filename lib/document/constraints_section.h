/// \file The section `constraints`, which people write.
#pragma once

#include "basecomplex/base_complex.h"
#include "document/json_place.h"
#include "layout/constraints.h"

namespace qm {

/// Every edge must lie on a separatrix; required edges on the mesh boundary are left out, because they are
/// patch boundaries anyway. No edge may be required and forbidden at once, or have
/// two weights.
/// \param complex  with the feature seeds
[[nodiscard]] Constraints readConstraints(const QuadMesh& mesh, const BaseComplex& complex,
                                          const JsonPlace& section);

} // namespace qm
