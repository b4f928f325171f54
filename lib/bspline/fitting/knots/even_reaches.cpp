#include "bspline/fitting/knots/even_reaches.h"

#include <algorithm>
#include <cstddef>

namespace qm {
namespace {

/// In mesh edges: the shortest reach that is tried, even where a longer one is too long already.
constexpr double minReach = 1.0 / 8;

std::vector<double> limited(std::vector<double> reaches, double limit) {
    for (double& reach : reaches)
        reach = std::min(reach, limit);
    return reaches;
}

} // namespace

void shortenAtEvenVertices(const std::vector<EvenVertex>& vertices, double allowed, KnotPlan& plan) {
    for (const EvenVertex& vertex : vertices) {
        const std::vector<double> before = reachesAt(vertex, plan);
        if (before.empty() || minError(vertex, before) <= allowed) continue;
        double common = minReach;
        const double longest = std::ranges::max(before);
        while (nextDistance(common) < longest &&
               minError(vertex, limited(before, nextDistance(common))) <= allowed)
            common = nextDistance(common);
        for (std::size_t k = 0; k < before.size(); ++k)
            if (before[k] > common) plan.limitReach(vertex.borders[k].end, common);
    }
}

} // namespace qm
