/// \file Colours of segments.
#pragma once

#include "export/export.h"

#include <array>
#include <cstdint>
#include <vector>

namespace qm {

using Colour = std::array<std::uint8_t, 3>; ///< red, green, blue (sRGB)

/// One for every segment.
/// \param surfaces  needed for ColourBy::deviation
[[nodiscard]] std::vector<Colour> segmentColours(const Layout& layout, const Surfaces* surfaces, ColourBy by);

} // namespace qm
