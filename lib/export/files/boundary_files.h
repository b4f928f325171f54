/// \file Writes boundary representations as files, see step.cpp and iges.cpp.
#pragma once

#include "export/files/export_options.h"
#include "export/files/shape.h"

#include <array>
#include <cstddef>
#include <string>

namespace qm {

/// What STEP and IGES call units of length.
struct LengthUnitNames {
    const char* stepPrefix; ///< of the metre; of an inch, of the millimetres that it is counted in
    const char* igesName;
    int igesFlag; ///< the number that IGES has for it
};

[[nodiscard]] constexpr LengthUnitNames namesOf(LengthUnit unit) {
    constexpr std::array<LengthUnitNames, 4> names{
        {{".MILLI.", "MM", 2}, {".CENTI.", "CM", 10}, {"$", "M", 6}, {".MILLI.", "INCH", 1}}};
    return names.at(static_cast<std::size_t>(unit));
}

/// STEP AP214: every part of the boundary is a product, a solid if it is closed and otherwise a shell.
/// OpenCASCADE's own writer needs ten times the time and memory, rounds to 13 digits, and declares an
/// accuracy that makes readers widen every tolerance.
/// \param origins  become the faces' names
[[nodiscard]] std::string boundaryAsStep(const Boundary& boundary, const FaceOrigins& origins,
                                         const ExportOptions& options);

/// IGES 5.3.
/// \param origins  the first of a face is its label
/// \throw Error  if OpenCASCADE cannot translate the shape
[[nodiscard]] std::string shapeAsIges(const BoundaryShape& shape, const FaceOrigins& origins,
                                      const ExportOptions& options);

} // namespace qm
