/// \file Points and vectors as a document lists them.
#pragma once

#include <array>
#include <cmath>

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
[[nodiscard]] inline Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

} // namespace qm::check
