#include "remesh/polygons/planar_polygon.h"

#include "base/at.h"
#include "base/positions.h"
#include "remesh/polygons/polygon_edges.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace qm {

std::vector<double> turnsOf(const std::vector<PlanarPoint>& corners) {
    const std::size_t count = corners.size();
    std::vector<double> turns(count);
    for (std::size_t k = 0; k < count; ++k)
        turns[k] = turn(corners[(k + count - 1) % count], corners[k], corners[(k + 1) % count]);
    return turns;
}

std::vector<PlanarPoint> planarCorners(const Soup& soup, std::size_t face) {
    const auto corners = soup.face(face);
    Point normal = areaVector(soup, face);
    std::vector<PlanarPoint> places(corners.size(), PlanarPoint(0, 0));
    const double length = normal.norm();
    if (!(length > 0)) return places;
    normal /= length;
    const auto least = std::ranges::min_element(normal, {}, [](double x) { return std::abs(x); });
    Point axis(0, 0, 0); // the one that is farthest from the normal
    axis[positionIn(normal, least)] = 1;
    const Point u = (axis % normal).normalized(), v = normal % u;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Point place = soup.points[at(corners[k])] - soup.points[at(corners[0])];
        places[k] = PlanarPoint(u | place, v | place);
    }
    return places;
}

bool isConvex(const std::vector<PlanarPoint>& corners) {
    const std::vector<double> turns = turnsOf(corners);
    const double minTurn = std::min(straightTurn, std::numbers::pi / static_cast<double>(corners.size()) / 2);
    if (std::ranges::min(turns) < minTurn) return false;
    return std::reduce(turns.begin(), turns.end()) < 3 * std::numbers::pi; // it goes around once
}

bool isSeenFromItsMiddle(const std::vector<PlanarPoint>& corners) {
    const std::size_t count = corners.size();
    const PlanarPoint middle =
        std::reduce(corners.begin(), corners.end(), PlanarPoint(0, 0)) / static_cast<double>(count);
    const auto sideMiddle = [&](std::size_t k) {
        return (corners[k % count] + corners[(k + 1) % count]) / 2 - middle;
    };
    for (std::size_t k = 0; k < count; ++k)
        if (cross(sideMiddle(k), sideMiddle(k + 1)) <= 0) return false;
    return isConvex(corners);
}

} // namespace qm
