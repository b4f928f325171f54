/// \file The elements of an array that are checked against a schema.
#pragma once

#include "document/json/json.h"

#include <cstddef>
#include <vector>

namespace qm {

/// The positions of these elements: all of a short array, or of one with elements other than numbers; of a
/// long list of numbers, the first one that is not whole, the smallest, and the largest. As long as schemas
/// restrict such numbers by type and limits only, all are valid if these are.
[[nodiscard]] std::vector<std::size_t> shownElements(const Json::array_t& array);

} // namespace qm
