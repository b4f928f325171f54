/// \file Directions of one patch as those of another, which is turned against it by quarters.
#pragma once

#include <array>
#include <cstddef>

namespace qm {

/// A vector of parameters after a number of counter-clockwise quarter turns, 0 to 3.
template <class Number>
[[nodiscard]] constexpr std::array<Number, 2> turned(const std::array<Number, 2>& vector, int quarters) {
    switch (quarters) {
    case 0:
        return vector;
    case 1:
        return {-vector[1], vector[0]};
    case 2:
        return {-vector[0], -vector[1]};
    default:
        return {vector[1], -vector[0]};
    }
}

/// The column and row that control points of a square net have after so many quarter turns about its middle.
[[nodiscard]] constexpr std::array<int, 2> turnedIndex(const std::array<int, 2>& index, int degree,
                                                       int quarters) {
    // Twice the distances from the middle are whole numbers.
    const auto [i, j] = turned<int>({2 * index[0] - degree, 2 * index[1] - degree}, quarters);
    return {(i + degree) / 2, (j + degree) / 2};
}

/// A direction along u (0) or v (1), or against it.
struct Heading {
    std::size_t direction = 0;
    int sign = 1;
};

/// Where a direction leads after so many quarter turns.
[[nodiscard]] constexpr Heading turnedDirection(std::size_t direction, int quarters) {
    std::array<int, 2> unit{};
    unit[direction] = 1;
    const auto way = turned(unit, quarters);
    return way[0] != 0 ? Heading{0, way[0]} : Heading{1, way[1]};
}

} // namespace qm
