#include "bspline/fitting/planes/plane_demands.h"

#include "base/at.h"
#include "layout/sides.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace qm {

std::vector<PlaneDemand> demandsOf(const Patch& patch, const FlatPatch& flat, std::size_t first) {
    std::vector<PlaneDemand> demands;
    for (std::size_t k = 0; k < patch.controlPoints.size(); ++k)
        demands.push_back({first + k, flat.plane});
    const std::array<std::size_t, 2> count{at(patch.count[0]), at(patch.count[1])};
    for (int side = 0; side < 4; ++side)
        if (const auto& outline = flat.outlines[at(side)])
            for (std::size_t k = 0; k < count[directionAlong(side)]; ++k)
                demands.push_back({first + pointOnSide(count, side, k), *outline});
    return demands;
}

bool isFlat(const Patch& patch, const FlatPatch& flat, double distance) {
    return std::ranges::all_of(demandsOf(patch, flat, 0), [&](const PlaneDemand& demand) {
        return std::abs(demand.plane.distance(patch.controlPoints[demand.unknown])) <= distance;
    });
}

} // namespace qm
