/// \file Cubics of the unit interval by their values and slopes at its ends.
#pragma once

#include "bspline/reference/lattice/lagrange.h"

#include <array>
#include <vector>

namespace qm {

/// Cubics with value 0 at both ends of the unit interval and slope 1 at one, and with value 1 at one end and
/// slope 0 at both.
struct Hermite {
    std::array<Jet, 2> slope;
    std::array<Jet, 2> value;

    explicit Hermite(double t)
        : slope{{{t * (1 - t) * (1 - t), (1 - t) * (1 - 3 * t), 6 * t - 4},
                 {t * t * (t - 1), t * (3 * t - 2), 6 * t - 2}}},
          value{{{(1 + 2 * t) * (1 - t) * (1 - t), 6 * t * (t - 1), 12 * t - 6},
                 {t * t * (3 - 2 * t), 6 * t * (1 - t), 6 - 12 * t}}} {}
};

/// The cubics at the beginning of the unit interval, after each of some equal steps, and so at its end.
[[nodiscard]] inline std::vector<Hermite> hermiteByStep(int steps) {
    std::vector<Hermite> result;
    for (int k = 0; k <= steps; ++k)
        result.emplace_back(static_cast<double>(k) / steps);
    return result;
}

/// Between the values at a quad's corners, counter-clockwise from the first: flat at all of them.
template <class Value>
[[nodiscard]] Value betweenCorners(const Hermite& u, const Hermite& v, const std::array<Value, 4>& corners) {
    const auto& [a, b, c, d] = corners;
    return v.value[0][0] * (u.value[0][0] * a + u.value[1][0] * b) +
           v.value[1][0] * (u.value[0][0] * d + u.value[1][0] * c);
}

} // namespace qm
