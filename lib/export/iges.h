/// \file Boundary representations as IGES.
#pragma once

#include "export/export.h"
#include "export/shape.h"

#include <cstddef>
#include <string>
#include <vector>

namespace qm {

/// \param origins  of every face, the segments that it is made of: the first is its label
/// \throw Error  if OpenCASCADE cannot translate the shape
[[nodiscard]] std::string shapeAsIges(const BoundaryShape& shape,
                                      const std::vector<std::vector<std::size_t>>& origins,
                                      const ExportOptions& options);

} // namespace qm
