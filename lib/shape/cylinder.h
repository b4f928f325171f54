/// \file A cylinder with both its caps.
#pragma once

#include "shape/quad_list.h"
#include "shape/true_surface.h"

namespace qm {

/// Of radius 1 and height 3. Each cap has a grid in its middle, whose corners are extraordinary.
/// \param around  quads around, even and at least 4
[[nodiscard]] QuadList cylinderShape(int around);
[[nodiscard]] TrueSurface cylinderSurface();

} // namespace qm
