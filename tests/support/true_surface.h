/// \file The exact surface that a sample part's vertices lie on.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace qm::testing {

/// A curve in the half-plane x >= 0 that turns around a vertical axis: a straight line, or an arc that bulges
/// outwards. Outside is on the right of a line's direction.
struct Revolved {
    using Place = std::array<double, 2>; ///< distance from the axis, height

    Place axis{0, 0}; ///< x and y
    Place from{0, 0}; ///< of a line
    Place to{0, 0};
    double radius = 0;                  ///< of an arc, whose centre is `from`; 0: a line
    std::array<double, 2> angles{0, 0}; ///< where it begins and ends, at most a full turn apart; radians
};

/// A rectangle across one of the axes, with round holes that do not reach its sides.
struct FlatFace {
    std::size_t axis = 2;
    double level = 0;
    double outward = 1; ///< or -1: where outside is along the axis
    // Coordinates along the two other axes, in their cyclic order.
    std::array<double, 2> low{0, 0};
    std::array<double, 2> high{0, 0};
    std::vector<std::array<double, 2>> holes{}; ///< their centres
    double radius = 0;                          ///< of every hole
};

class TrueSurface {
public:
    struct Nearest {
        Point position{0, 0, 0};
        Point normal{0, 0, 0}; ///< of unit length, outward
        double distance = 0;
    };

    explicit TrueSurface(std::vector<std::variant<Revolved, FlatFace>> pieces) : pieces_(std::move(pieces)) {}

    /// The nearest point, up to rounding.
    [[nodiscard]] Nearest nearest(const Point& point) const;

private:
    std::vector<std::variant<Revolved, FlatFace>> pieces_;
};

/// Of a sample part (see shape/shape.h), by its name; nothing for those without a formula.
[[nodiscard]] std::optional<TrueSurface> trueSurface(const std::string& part);

} // namespace qm::testing
