/// \file Boundary representations as files: step.cpp and iges.cpp.
#pragma once

#include "export/export.h"
#include "export/shape.h"

#include <cstddef>
#include <string>
#include <vector>

namespace qm {

/// AP214: every part of the boundary is a product, a solid if it is closed and else a shell. OpenCASCADE has
/// a writer, too, but needs ten times the time and memory, rounds to 13 digits, and declares an accuracy that
/// makes readers widen every tolerance.
/// \param origins  of every face, the segments that it is made of, and its name
[[nodiscard]] std::string boundaryAsStep(const Boundary& boundary,
                                         const std::vector<std::vector<std::size_t>>& origins,
                                         const ExportOptions& options);

/// IGES 5.3.
/// \param origins  of every face, the segments that it is made of: the first is its label
/// \throw Error  if OpenCASCADE cannot translate the shape
[[nodiscard]] std::string shapeAsIges(const BoundaryShape& shape,
                                      const std::vector<std::vector<std::size_t>>& origins,
                                      const ExportOptions& options);

} // namespace qm
