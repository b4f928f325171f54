#include "bspline/fitting/system/free_patches.h"

#include "bspline/fitting/system/continuity_equations.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace qm {

std::vector<bool> freePatches(const std::vector<Stretch>& stretches, const std::vector<PatchSpace>& spaces,
                              const std::vector<bool>& changed, int rings, double worthAll) {
    // If few patches have changed, more of those around are solved for, up to this many control points.
    constexpr double minPoints = 1000;
    std::vector<bool> isFree = withNeighbours(stretches, changed, rings);
    const auto points = [&] {
        std::size_t count = 0;
        for (std::size_t k = 0; k < spaces.size(); ++k)
            if (isFree[k]) count += spaces[k].size();
        return static_cast<double>(count);
    };
    const double limit = worthAll * static_cast<double>(unknownsOf(spaces));
    for (double last = -1; points() > last && points() < std::min(minPoints, limit);) {
        last = points();
        isFree = withNeighbours(stretches, std::move(isFree), 1);
    }
    if (points() > limit) isFree.assign(spaces.size(), true);
    return isFree;
}

} // namespace qm
