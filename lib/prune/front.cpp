#include "prune/front.h"

#include <algorithm>

namespace qm {
namespace {

bool dominates(const FrontPoint& one, const FrontPoint& other) {
    constexpr double rounding = 1e-9;
    return one.segments <= other.segments && one.cost <= other.cost + rounding &&
           one.capturedSharpness >= other.capturedSharpness - rounding;
}

} // namespace

void addToFront(std::vector<FrontPoint>& front, const FrontPoint& point) {
    if (std::ranges::any_of(front, [&](const FrontPoint& other) { return dominates(other, point); })) return;
    std::erase_if(front, [&](const FrontPoint& other) { return dominates(point, other); });
    front.push_back(point);
}

} // namespace qm
