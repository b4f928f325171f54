/// \file Bounding boxes.
#pragma once

#include "mesh/quad_mesh.h"

#include <functional>
#include <ranges>

namespace qm {

/// The smallest axis-parallel box that contains some points.
struct BoundingBox {
    Point low{0, 0, 0};
    Point high{0, 0, 0};

    [[nodiscard]] Point size() const { return high - low; }
    [[nodiscard]] Point centre() const { return (low + high) / 2; }
    [[nodiscard]] double diagonal() const { return size().norm(); }

    void include(const Point& point) {
        low.minimize(point);
        high.maximize(point);
    }
};

/// \param pointOf the point of an element of `items`
/// \return the origin if there are no items
template <std::ranges::forward_range Items, typename PointOf = std::identity>
[[nodiscard]] BoundingBox boundingBoxOf(const Items& items, const PointOf& pointOf = {}) {
    if (std::ranges::empty(items)) return {};
    const Point first = std::invoke(pointOf, *std::ranges::begin(items));
    BoundingBox box{first, first};
    for (const auto& item : items)
        box.include(std::invoke(pointOf, item));
    return box;
}

/// The box of all vertices used by faces.
[[nodiscard]] BoundingBox boundingBox(const QuadMesh& mesh);

} // namespace qm
