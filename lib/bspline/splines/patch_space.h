/// \file The bicubic splines of which a patch is one.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// The bicubic spline space of a patch: clamped knots in full, along u and along v.
struct PatchSpace {
    std::array<std::vector<double>, 2> knots;
    std::size_t firstUnknown = 0; ///< control point (i, j) is unknown firstUnknown + j * count(0) + i

    [[nodiscard]] std::size_t count(std::size_t direction) const { return knots[direction].size() - 4; }
    [[nodiscard]] std::size_t size() const { return count(0) * count(1); }
};

} // namespace qm
