/// \file The elements of an array that a schema check looks at.
#pragma once

#include "document/json.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Their positions: all of a short array, and of one that holds anything but numbers; of a long list of
/// numbers the first that is not whole, the smallest, and the largest. As long as schemas ask of such numbers
/// nothing but a type and limits, all are valid if these are.
[[nodiscard]] std::vector<std::size_t> shownElements(const Json::array_t& array);

} // namespace qm
