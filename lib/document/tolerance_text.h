/// \file Tolerances as users and documents write them: "0.1%" or "0.05".
#pragma once

#include "bspline/fit.h"

#include <string>
#include <string_view>

namespace qm {

[[nodiscard]] std::string toleranceText(const Tolerance& tolerance);

/// Reads a whole text; false, with `tolerance` as it was, if it is no positive number with or without %.
[[nodiscard]] bool parseTolerance(std::string_view text, Tolerance& tolerance);

} // namespace qm
