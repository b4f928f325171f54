#include "export/simple/smooth_borders.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

using Eigen::Vector3d;

double degreesBetween(const Vector3d& one, const Vector3d& other) {
    return std::atan2(one.cross(other).norm(), one.dot(other)) * (180 / std::numbers::pi);
}

/// A point near a given one on both surfaces, or nearest to that.
Vector3d commonPoint(Vector3d point, const SimpleShape& one, const SimpleShape& other) {
    constexpr int rounds = 20; // where it takes more, the surfaces touch, and their normals hardly change
    for (int round = 0; round < rounds; ++round)
        for (const SimpleShape* shape : {&one, &other})
            point -= shape->normal(point) * shape->distance(point);
    return point;
}

/// Largest angle between the two surfaces at a border, in degrees: along the border, and where they meet near
/// it.
/// \param shapes  by side; nothing if the patch stays
double bendAt(const SmoothBorder& border, const std::array<const std::optional<PlacedShape>*, 2>& shapes) {
    double largest = 0;
    const auto& [one, other] = shapes;
    for (std::size_t k = 0; k < border.points.size(); ++k) {
        const auto normalAt = [&](std::size_t side, const Vector3d& point) -> Vector3d {
            const auto& placed = *shapes.at(side);
            return placed ? placed->side * placed->shape.normal(point) : border.normals.at(side)[k];
        };
        const auto bend = [&](const Vector3d& point) {
            return degreesBetween(normalAt(0, point), normalAt(1, point));
        };
        largest = std::max(largest, bend(border.points[k]));
        if (*one && *other)
            largest = std::max(largest, bend(commonPoint(border.points[k], (*one)->shape, (*other)->shape)));
    }
    return largest;
}

} // namespace

void keepSmooth(const std::vector<SmoothBorder>& borders, std::vector<std::optional<PlacedShape>>& shapes) {
    std::vector<std::vector<std::size_t>> bordersOf(shapes.size());
    std::vector<std::size_t> left;
    for (std::size_t b = 0; b < borders.size(); ++b) {
        left.push_back(b);
        for (const std::size_t patch : borders[b].patches)
            bordersOf[patch].push_back(b);
    }
    while (!left.empty()) {
        const SmoothBorder& border = borders[left.back()];
        left.pop_back();
        const std::array<const std::optional<PlacedShape>*, 2> both{&shapes[border.patches[0]],
                                                                    &shapes[border.patches[1]]};
        if (bendAt(border, both) <= maxNewAngle) continue;
        const auto weight = [&](std::size_t side) {
            const auto& placed = *both.at(side);
            return placed && placed->mayGo ? std::optional(placed->weight) : std::nullopt;
        };
        const auto first = weight(0);
        const auto second = weight(1);
        if (!first && !second) continue;
        const std::size_t patch = border.patches.at(!first || (second && *second < *first) ? 1 : 0);
        shapes[patch].reset();
        left.insert(left.end(), bordersOf[patch].begin(), bordersOf[patch].end());
    }
}

} // namespace qm
