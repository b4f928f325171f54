#include "view/palette.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace qm {

std::vector<std::uint32_t>
colourNumbers(std::size_t items, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& neighbours) {
    std::vector<std::vector<std::uint32_t>> around(items);
    for (const auto& [a, b] : neighbours) {
        if (a == b) continue;
        around[a].push_back(b);
        around[b].push_back(a);
    }
    // Those with many neighbours choose first.
    std::vector<std::uint32_t> order(items);
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&around](std::uint32_t item) { return around[item].size(); });
    std::vector<std::uint32_t> colours(items, colourCount);
    std::array<std::size_t, colourCount> used{};
    for (const std::uint32_t item : order) {
        std::array<std::size_t, colourCount + 1> nearby{};
        for (const std::uint32_t other : around[item])
            ++nearby.at(colours[other]);
        std::uint32_t best = 0;
        for (std::uint32_t colour = 1; colour < colourCount; ++colour)
            if (std::pair(nearby.at(colour), used.at(colour)) < std::pair(nearby.at(best), used.at(best)))
                best = colour;
        colours[item] = best;
        ++used.at(best);
    }
    return colours;
}

} // namespace qm
