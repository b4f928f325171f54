#include "bspline/fitting/verified_flattening.h"

#include "bspline/fitting/planes/moving_groups.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace qm {

bool dropPlanes(const std::vector<Stretch>& stretches, std::vector<bool> isSpoiled,
                std::vector<std::optional<FlatPatch>>& planes) {
    if (std::ranges::find(isSpoiled, true) == isSpoiled.end()) return false;
    bool areDropped = false;
    for (int ring = 0; ring <= ringsAroundPlanes && !areDropped; ++ring) {
        if (ring > 0) isSpoiled = withNeighbours(stretches, std::move(isSpoiled), 1);
        for (std::size_t patch = 0; patch < planes.size(); ++patch)
            if (isSpoiled[patch] && planes[patch]) {
                planes[patch].reset();
                areDropped = true;
            }
    }
    return true;
}

void flattenWhereKept(const Verification& verify, int slides, std::vector<std::optional<FlatPatch>>& planes,
                      FitState& state, FitRound& round) {
    constexpr int attempts = 5;
    constexpr double worse = 1.01; // times as far as before; less may be an error of measurement
    for (int k = 0; k < attempts; ++k) {
        state.restore(round);
        const std::vector<bool> wasFolded = state.errors().areFolded();
        if (!state.flatten(planes, slides)) return;
        const std::vector<bool> isFolded = state.errors().areFolded();
        FitRound flat = state.round();
        flat.distances = verify(flat.patches);
        std::vector<bool> isSpoiled(flat.patches.size());
        for (std::size_t patch = 0; patch < isSpoiled.size(); ++patch)
            isSpoiled[patch] = (isFolded[patch] && !wasFolded[patch]) ||
                               flat.distances[patch] > std::max(1.0, worse * round.distances[patch]);
        if (dropPlanes(flat.plan->stretches(), std::move(isSpoiled), planes)) continue;
        round = std::move(flat);
        return;
    }
}

} // namespace qm
