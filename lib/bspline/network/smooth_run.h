/// \file Runs along which surfaces are smooth, and how their derivatives across the border are tied to the
/// one along it.
#pragma once

#include <array>
#include <cstddef>

namespace qm {

/// The function lambda of a smooth border, over 0 to its length: from the values at its ends it falls to
/// zero, quadratically, within a reach from either end; or, if it has no reach, it is linear from end to end.
struct TangentRatio {
    std::array<double, 2> atEnd{};
    std::array<double, 2> reach{}; ///< 0 only if the value is; together at most the length
    bool isLinear = false;
    double length = 0;

    bool operator==(const TangentRatio&) const = default;

    [[nodiscard]] double operator()(double x) const {
        if (isLinear) return atEnd[0] + (atEnd[1] - atEnd[0]) * x / length;
        return quadratic(0, x) + quadratic(1, length - x);
    }

private:
    [[nodiscard]] double quadratic(std::size_t end, double distance) const {
        if (atEnd[end] == 0 || distance >= reach[end]) return 0;
        const double rest = 1 - distance / reach[end];
        return atEnd[end] * rest * rest;
    }
};

/// A run of smooth edges of a stretch, in mesh edges from the stretch's beginning.
struct SmoothRun {
    std::size_t stretch = 0;
    int begin = 0;
    int end = 0;
    TangentRatio ratio; ///< over 0 to end - begin

    /// The stretch's parameter at a distance from the run's beginning (0) or end (1).
    [[nodiscard]] double parameterAt(std::size_t which, double distance) const {
        return which == 0 ? begin + distance : end - distance;
    }
    /// The distance of a parameter of the stretch from there.
    [[nodiscard]] double distanceFrom(std::size_t which, double parameter) const {
        return which == 0 ? parameter - begin : end - parameter;
    }
};

} // namespace qm
