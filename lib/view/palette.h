/// \file Colours by number, so that neighbours differ.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace qm {

/// Number of colours that the page has for items side by side.
constexpr std::uint32_t colourCount = 8;

/// A number below `colourCount` for every item: the one that fewest neighbours have, and of several such the
/// one that fewest items have.
/// \param neighbours  pairs of items, in any order and number
[[nodiscard]] std::vector<std::uint32_t>
colourNumbers(std::size_t items, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& neighbours);

} // namespace qm
