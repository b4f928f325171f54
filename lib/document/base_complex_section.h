/// \file The section `baseComplex`.
#pragma once

#include "basecomplex/base_complex.h"
#include "document/json_place.h"

namespace qm {

/// \param complex  without seeds
[[nodiscard]] Json baseComplexToJson(const QuadMesh& mesh, const BaseComplex& complex);

/// The base complex follows from the mesh; it is computed anew and must agree.
/// \throw Error  with the pointer of the first difference
void verifyBaseComplex(const QuadMesh& mesh, const BaseComplex& complex, const JsonPlace& section);

} // namespace qm
