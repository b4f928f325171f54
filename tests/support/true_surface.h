/// \file The exact surfaces on which the vertices of sample parts lie.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace qm::test {

/// A surface of revolution: a straight line or an arc that bulges outwards, in the half-plane x >= 0, turned
/// around a vertical axis. Outside is to the right of a line's direction.
struct Revolved {
    using Place = std::array<double, 2>; ///< distance from the axis, height

    Place axis{0, 0}; ///< x and y
    Place from{0, 0}; ///< beginning of a line, or centre of an arc
    Place to{0, 0};
    double radius = 0;                  ///< of an arc; 0 for a line
    std::array<double, 2> angles{0, 0}; ///< beginning and end of an arc, at most a full turn apart; radians
};

/// A rectangle perpendicular to an axis, with round holes that do not reach its sides.
struct FlatFace {
    std::size_t axis = 2;
    double level = 0;
    double outward = 1; ///< direction of outside along the axis: 1 or -1
    // Coordinates along the two other axes, in their cyclic order.
    std::array<double, 2> low{0, 0};
    std::array<double, 2> high{0, 0};
    std::vector<std::array<double, 2>> holes{}; ///< centres
    double radius = 0;                          ///< of every hole
};

class TrueSurface {
public:
    struct Nearest {
        Point position{0, 0, 0};
        Point normal{0, 0, 0}; ///< of unit length, outwards
        double distance = 0;
    };

    explicit TrueSurface(std::vector<std::variant<Revolved, FlatFace>> pieces) : pieces_(std::move(pieces)) {}

    /// The nearest point, up to rounding.
    [[nodiscard]] Nearest nearest(const Point& point) const;

private:
    std::vector<std::variant<Revolved, FlatFace>> pieces_;
};

/// The surface of a sample part (see shape/shape.h), by name; nothing for parts without a formula.
[[nodiscard]] std::optional<TrueSurface> trueSurface(const std::string& part);

} // namespace qm::test
