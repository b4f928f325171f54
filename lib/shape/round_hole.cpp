#include "shape/round_hole.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {

double RoundHole::outwardness(Place place) const {
    return (std::max(std::abs(place.x), std::abs(place.y)) - hole) / (frame - hole);
}

RoundHole::Place RoundHole::at(Place direction, double outwardness) const {
    const double size = std::max(std::abs(direction.x), std::abs(direction.y));
    if (size == 0) return direction;
    const Place onSquare{direction.x / size, direction.y / size};
    // Equal steps along a side of the square become equal angles.
    const bool sideways = std::abs(direction.x) >= std::abs(direction.y);
    const double angle = (sideways ? onSquare.y : onSquare.x) * std::numbers::pi / 4;
    const Place onCircle = sideways ? Place{std::copysign(std::cos(angle), direction.x), std::sin(angle)}
                                    : Place{std::sin(angle), std::copysign(std::cos(angle), direction.y)};
    const double inner = (1 - outwardness) * radius, outer = outwardness * frame;
    return {inner * onCircle.x + outer * onSquare.x, inner * onCircle.y + outer * onSquare.y};
}

RoundHole::Place RoundHole::moved(Place place) const {
    const double outward = outwardness(place);
    return outward < 1 ? at(place, outward) : place;
}

} // namespace qm
