/// \file Figures as a person reads them: three digits, and no exponents where they can be done without.
#pragma once

#include "mesh/quad_mesh.h"
#include "summary/summary.h"

#include <array>
#include <string>

namespace qm {

/// "0.0123", "12.3", "1234", "1.2e-15".
[[nodiscard]] std::string figureText(double value);

/// Two figures that differ, with as many more digits as tell them apart.
[[nodiscard]] std::array<std::string, 2> figuresApart(double one, double other);

/// "(0.12, 3.4, 5)".
/// \param extent  of what the point lies on: far from the origin, a place is told to three digits of it
[[nodiscard]] std::string pointText(const Point& point, double extent);

/// "in patch 3 at (0.12, 3.4, 5)".
[[nodiscard]] std::string placeText(const SurfacePlace& place, double extent);

} // namespace qm
