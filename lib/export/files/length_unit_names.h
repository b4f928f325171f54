/// \file What STEP and IGES call units of length.
#pragma once

#include "export/files/export_options.h"

#include <array>
#include <cstddef>

namespace qm {

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

} // namespace qm
