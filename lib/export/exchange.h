/// \file Boundary representations as STEP and IGES.
#pragma once

#include "export/export.h"
#include "export/shape.h"

#include <cstddef>
#include <string>
#include <vector>

namespace qm {

/// \param origins  of every face, the segments that it is made of: its name in STEP; its label in IGES, which
/// are short, is the first \throw Error  if OpenCASCADE cannot translate the shape
[[nodiscard]] std::string shapeAsStep(const BoundaryShape& shape,
                                      const std::vector<std::vector<std::size_t>>& origins, LengthUnit unit);
[[nodiscard]] std::string shapeAsIges(const BoundaryShape& shape,
                                      const std::vector<std::vector<std::size_t>>& origins, LengthUnit unit);

} // namespace qm
