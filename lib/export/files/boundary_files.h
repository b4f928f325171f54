/// \file Writes boundary representations as files, see step.cpp and iges.cpp.
#pragma once

#include "export/files/export_options.h"
#include "export/files/shape.h"

#include <cstddef>
#include <string>
#include <vector>

namespace qm {

/// STEP AP214: every part of the boundary is a product, a solid if it is closed and otherwise a shell.
/// OpenCASCADE's own writer needs ten times the time and memory, rounds to 13 digits, and declares an
/// accuracy that makes readers widen every tolerance.
/// \param origins  by face: the segments that it consists of, and its name
[[nodiscard]] std::string boundaryAsStep(const Boundary& boundary,
                                         const std::vector<std::vector<std::size_t>>& origins,
                                         const ExportOptions& options);

/// IGES 5.3.
/// \param origins  by face: the segments that it consists of; the first is its label
/// \throw Error  if OpenCASCADE cannot translate the shape
[[nodiscard]] std::string shapeAsIges(const BoundaryShape& shape,
                                      const std::vector<std::vector<std::size_t>>& origins,
                                      const ExportOptions& options);

} // namespace qm
