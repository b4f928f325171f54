/// \file Points and vectors as a document lists them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace qm::check {

using Place = std::array<double, 3>;
using Vector = Place;

[[nodiscard]] inline Vector minus(const Place& a, const Place& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

[[nodiscard]] inline double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

[[nodiscard]] inline double length(const Vector& a) {
    return std::sqrt(dot(a, a));
}

[[nodiscard]] inline double distance(const Place& a, const Place& b) {
    return length(minus(a, b));
}

[[nodiscard]] inline Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The largest coordinate, by which rounding is judged.
[[nodiscard]] inline double largestCoordinate(std::span<const Place> points) {
    double largest = 0;
    for (const Place& point : points)
        for (const double x : point)
            largest = std::max(largest, std::abs(x));
    return largest;
}

} // namespace qm::check
