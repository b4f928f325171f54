/// \file Distances or angles at places that stand for areas, and what is said of all of them together.
#pragma once

#include <compare>
#include <vector>

namespace qm {

struct Sample {
    double value = 0;
    double weight = 1; ///< the area
    // NOLINTNEXTLINE(modernize-use-nullptr): the compiler generates this 0
    auto operator<=>(const Sample&) const = default;
};

using Samples = std::vector<Sample>;

/// All of these are 0 if there are no samples, or none of any weight.
[[nodiscard]] double largest(const Samples& samples);
[[nodiscard]] double rootMeanSquare(const Samples& samples);
/// By weight, not by number.
[[nodiscard]] double percentile95(Samples samples);

void append(Samples& samples, const Samples& more);

} // namespace qm
