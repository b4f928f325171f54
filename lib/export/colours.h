/// \file Colours of segments.
#pragma once

#include "bspline/splines/surfaces.h"
#include "export/files/export_options.h"
#include "layout/layout.h"

#include <array>
#include <cstdint>
#include <vector>

namespace qm {

using Colour = std::array<std::uint8_t, 3>; ///< red, green, blue (sRGB)

/// The colours of all segments.
/// \param surfaces  needed for ColourBy::deviation only
[[nodiscard]] std::vector<Colour> segmentColours(const Layout& layout, const Surfaces* surfaces, ColourBy by);

} // namespace qm
