/// \file The section `baseComplex`.
#pragma once

#include "basecomplex/base_complex.h"
#include "document/json/json_place.h"

namespace qm {

/// \param complex  without seeds
[[nodiscard]] Json baseComplexToJson(const QuadMesh& mesh, const BaseComplex& complex);

/// Computes the base complex anew from the mesh; the section must agree with it.
/// \throw Error  with the JSON pointer of the first difference
void verifyBaseComplex(const QuadMesh& mesh, const BaseComplex& complex, const JsonPlace& section);

} // namespace qm
