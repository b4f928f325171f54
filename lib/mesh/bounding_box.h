/// \file Bounding boxes.
#pragma once

#include "mesh/quad_mesh.h"

#include <ranges>

namespace qm {

/// The smallest axis-parallel box that contains some points.
struct BoundingBox {
    Point low{0, 0, 0};
    Point high{0, 0, 0};

    [[nodiscard]] Point size() const { return high - low; }
    [[nodiscard]] Point centre() const { return (low + high) / 2; }
    [[nodiscard]] double diagonal() const { return size().norm(); }
};

/// \return the origin if there are no points
template <std::ranges::forward_range Points> [[nodiscard]] BoundingBox boundingBoxOf(const Points& points) {
    if (std::ranges::empty(points)) return {};
    BoundingBox box{*std::ranges::begin(points), *std::ranges::begin(points)};
    for (const Point& point : points) {
        box.low.minimize(point);
        box.high.maximize(point);
    }
    return box;
}

/// The box of all vertices used by faces.
[[nodiscard]] BoundingBox boundingBox(const QuadMesh& mesh);

} // namespace qm
