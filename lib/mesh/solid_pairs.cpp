#include "mesh/solid_pairs.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

/// The faces with their angles around the edge, in the right-handed sense and in the order of these.
std::vector<std::pair<double, FaceAtEdge>> inCircle(const Point& direction,
                                                    std::span<const FaceAtEdge> faces) {
    Point axis = direction;
    axis.normalize_cond();
    Point first = faces.front().inward;
    first -= axis * (axis | first);
    first.normalize_cond();
    const Point second = axis % first;
    std::vector<std::pair<double, FaceAtEdge>> around;
    for (const FaceAtEdge& face : faces) {
        const double angle = std::atan2(face.inward | second, face.inward | first);
        around.emplace_back(std::isfinite(angle) ? angle : 0, face);
    }
    std::ranges::sort(around, {},
                      [](const auto& entry) { return std::pair(entry.first, entry.second.side); });
    return around;
}

} // namespace

std::vector<std::pair<Side, Side>> pairsAroundSolids(const Point& direction,
                                                     std::span<const FaceAtEdge> faces) {
    if (faces.empty()) return {};
    std::vector<std::pair<Side, Side>> pairs;
    std::vector<Side> open, behind; // behind: those that ascend before all that are open at angle 0 are known
    for (const auto& [angle, face] : inCircle(direction, faces)) {
        if (!face.ascends) {
            open.push_back(face.side);
        } else if (open.empty()) {
            behind.push_back(face.side);
        } else {
            pairs.emplace_back(open.back(), face.side);
            open.pop_back();
        }
    }
    for (const Side side : behind) {
        if (open.empty()) break;
        pairs.emplace_back(open.back(), side);
        open.pop_back();
    }
    return pairs;
}

} // namespace qm
