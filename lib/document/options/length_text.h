/// \file Lengths as users and documents write them: "0.1%" or "0.05".
#pragma once

#include "base/length.h"

#include <string>
#include <string_view>

namespace qm {

[[nodiscard]] std::string lengthText(const Length& length);

/// Reads a whole text as a number, not negative, with or without %. If it is anything else, returns false and
/// leaves `length` unchanged.
[[nodiscard]] bool parseLength(std::string_view text, Length& length);

} // namespace qm
