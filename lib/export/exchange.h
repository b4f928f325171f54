/// \file Boundary representations as STEP and IGES.
#pragma once

#include "export/export.h"
#include "export/shape.h"

#include <string>

namespace qm {

/// \throw Error  if OpenCASCADE cannot translate the shape
[[nodiscard]] std::string shapeAsStep(const BoundaryShape& shape, LengthUnit unit);
[[nodiscard]] std::string shapeAsIges(const BoundaryShape& shape, LengthUnit unit);

} // namespace qm
