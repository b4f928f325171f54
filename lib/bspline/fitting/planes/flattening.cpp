#include "bspline/fitting/planes/flattening.h"

#include "base/parallel.h"
#include "bspline/fitting/planes/group_flattening.h"
#include "bspline/fitting/planes/moving_groups.h"

#include <algorithm>
#include <cstddef>

namespace qm {

bool flatten(const KnotPlan& plan, std::vector<std::optional<FlatPatch>>& flat, std::vector<Patch>& patches,
             unsigned jobs) {
    const std::vector<MovingGroup> groups = movingGroups(plan, flat, patches);
    std::vector<char> hasMoved(groups.size());
    parallelFor(groups.size(), jobs, [&](std::size_t k) {
        if (flattenGroup(groups[k], flat, patches)) hasMoved[k] = 1;
    });
    return std::ranges::find(hasMoved, 1) != hasMoved.end();
}

} // namespace qm
