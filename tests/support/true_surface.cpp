#include "support/true_surface.h"

#include "base/infinity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm::test {
namespace {

using Place = Revolved::Place;

struct Foot {
    Place place;
    Place normal;
};

Foot footOnLine(const Revolved& curve, const Place& place) {
    const double x = curve.to[0] - curve.from[0];
    const double y = curve.to[1] - curve.from[1];
    const double square = x * x + y * y;
    const double t =
        std::clamp(((place[0] - curve.from[0]) * x + (place[1] - curve.from[1]) * y) / square, 0.0, 1.0);
    const double length = std::sqrt(square);
    return {{curve.from[0] + t * x, curve.from[1] + t * y}, {y / length, -x / length}};
}

Foot footOnArc(const Revolved& curve, const Place& place) {
    constexpr double turn = 2 * std::numbers::pi;
    const auto at = [&](double angle) -> Foot {
        const Place normal{std::cos(angle), std::sin(angle)};
        return {{curve.from[0] + curve.radius * normal[0], curve.from[1] + curve.radius * normal[1]}, normal};
    };
    const double angle = std::atan2(place[1] - curve.from[1], place[0] - curve.from[0]);
    const double begun = std::fmod(angle - curve.angles[0] + 2 * turn, turn);
    const double whole = curve.angles[1] - curve.angles[0];
    if (begun <= whole) return at(angle);
    return at(begun - whole < turn - begun ? curve.angles[1] : curve.angles[0]);
}

TrueSurface::Nearest nearestOn(const Revolved& curve, const Point& point) {
    const double x = point[0] - curve.axis[0];
    const double y = point[1] - curve.axis[1];
    const double out = std::hypot(x, y);
    const Place direction = out > 0 ? Place{x / out, y / out} : Place{1, 0};
    const Place place{out, point[2]};
    const Foot foot = curve.radius > 0 ? footOnArc(curve, place) : footOnLine(curve, place);
    TrueSurface::Nearest result;
    result.position = {curve.axis[0] + foot.place[0] * direction[0],
                       curve.axis[1] + foot.place[0] * direction[1], foot.place[1]};
    result.normal = {foot.normal[0] * direction[0], foot.normal[0] * direction[1], foot.normal[1]};
    result.distance = (result.position - point).norm();
    return result;
}

TrueSurface::Nearest nearestOn(const FlatFace& face, const Point& point) {
    const std::size_t first = (face.axis + 1) % 3;
    const std::size_t second = (face.axis + 2) % 3;
    TrueSurface::Nearest result;
    result.position[face.axis] = face.level;
    result.normal[face.axis] = face.outward;
    double x = std::clamp(point[first], face.low[0], face.high[0]);
    double y = std::clamp(point[second], face.low[1], face.high[1]);
    for (const auto& centre : face.holes) {
        const double out = std::hypot(x - centre[0], y - centre[1]);
        if (out >= face.radius) continue;
        const Place direction = out > 0 ? Place{(x - centre[0]) / out, (y - centre[1]) / out} : Place{1, 0};
        x = centre[0] + face.radius * direction[0];
        y = centre[1] + face.radius * direction[1];
        break;
    }
    result.position[first] = x;
    result.position[second] = y;
    result.distance = (result.position - point).norm();
    return result;
}

} // namespace

TrueSurface::Nearest TrueSurface::nearest(const Point& point) const {
    Nearest best;
    best.distance = infinity;
    for (const auto& piece : pieces_) {
        const Nearest found = std::visit([&](const auto& p) { return nearestOn(p, point); }, piece);
        if (found.distance < best.distance) best = found;
    }
    return best;
}

} // namespace qm::test
