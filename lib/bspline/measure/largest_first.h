/// \file Branch and bound for the largest distance, whatever the parts are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace qm {

/// Divides parts, always the one with the largest bound, until all bounds are closed or the effort is spent.
/// \param parts     each with an upper bound of its distances, `upper`
/// \param effort    number of parts that may be made, but for those of the last division
/// \param isClosed  whether a bound is close enough to what was found
/// \param divide    called with a part and a function, which it calls with all parts of that part
/// \return an upper bound for all parts
template <class Part, class IsClosed, class Divide>
[[nodiscard]] double boundLargestFirst(std::vector<Part> parts, std::size_t effort, const IsClosed& isClosed,
                                       const Divide& divide) {
    double bound = 0; // of the closed parts that are not in the heap
    std::size_t made = 0;
    const auto add = [&](Part part) {
        ++made;
        if (isClosed(part.upper)) {
            bound = std::max(bound, part.upper);
            return;
        }
        parts.push_back(std::move(part));
        std::ranges::push_heap(parts, {}, &Part::upper);
    };
    std::ranges::make_heap(parts, {}, &Part::upper);
    while (!parts.empty() && !isClosed(parts.front().upper) && made < effort) {
        std::ranges::pop_heap(parts, {}, &Part::upper);
        const Part part = std::move(parts.back());
        parts.pop_back();
        divide(part, add);
    }
    return parts.empty() ? bound : std::max(bound, parts.front().upper);
}

} // namespace qm
