#include "base/number_text.h"
#include "check/check_sections.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <tuple>
#include <vector>

namespace qm::check {

namespace {

constexpr const char* place = "/layout/prune/front";

using Point = LayoutPart::FrontPoint;

/// Points that others are as good as in everything.
std::vector<std::size_t> covered(const std::vector<Point>& front) {
    std::vector<std::size_t> order(front.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) {
        return std::tuple(front[i].segments, front[i].cost, -front[i].capturedSharpness);
    });
    std::vector<std::size_t> result;
    std::map<double, double> best; // of those of no more segments: cost and sharpness, both ascending
    for (const std::size_t i : order) {
        const Point& point = front[i];
        const auto after = best.upper_bound(point.cost);
        if (after != best.begin() && std::prev(after)->second >= point.capturedSharpness) {
            result.push_back(i);
            continue;
        }
        auto worse = best.lower_bound(point.cost);
        while (worse != best.end() && worse->second <= point.capturedSharpness)
            worse = best.erase(worse);
        best.emplace(point.cost, point.capturedSharpness);
    }
    return result;
}

/// Front and bound come out of sums in different orders.
double slackOf(const Point& point) {
    return 1e-6 * std::max({1.0, std::abs(point.cost), point.beta * point.segments});
}

} // namespace

void checkFront(const LayoutPart& part, Report& report) {
    const auto& front = part.front;
    for (const std::size_t i : covered(front))
        report.violate(below(place, i), "front", "another is as good in everything");
    for (std::size_t i = 0; i < front.size(); ++i) {
        const Point& point = front[i];
        if (i > 0 && point.segments > front[i - 1].segments)
            report.violate(below(place, i, "segments"), "front", "there are more than in the one before");
        const double objective = point.cost + point.beta * point.segments;
        if (point.objectiveBound && *point.objectiveBound > objective + slackOf(point))
            report.violate(below(place, i, "objectiveBound"), "front",
                           "the layout is below it: " + numberText(objective));
        if (point.proven && std::abs(point.objectiveBound.value_or(objective) - objective) > slackOf(point))
            report.violate(below(place, i, "proven"), "front",
                           "the bound is not attained: it is " + numberText(objective));
    }
}

} // namespace qm::check
