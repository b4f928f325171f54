#include "bspline/fitting/verified_flattening.h"

#include "bspline/fitting/planes/flattening.h"
#include "bspline/fitting/system/free_patches.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace qm {
namespace {

/// Drops the planes of spoiled patches and of those beside them.
/// \return whether there are any
bool dropSpoiled(const std::vector<Stretch>& stretches, const std::vector<bool>& isSpoiled,
                 std::vector<std::optional<FlatPatch>>& planes) {
    const std::vector<bool> dropped = withNeighbours(stretches, isSpoiled, 1);
    for (std::size_t patch = 0; patch < planes.size(); ++patch)
        if (dropped[patch]) planes[patch].reset();
    return std::ranges::find(isSpoiled, true) != isSpoiled.end();
}

} // namespace

void flattenWhereKept(const FitProblem& problem, std::vector<std::optional<FlatPatch>> planes,
                      FitRound& round, unsigned jobs) {
    constexpr int attempts = 5;
    constexpr double worse = 1.01; // times as far as before; less may be an error of measurement
    const KnotPlan& plan = *round.plan;
    const std::vector<PatchSpace> spaces = plan.spaces();
    for (int k = 0; k < attempts; ++k) {
        std::vector<Patch> flat = round.patches;
        flatten(problem.layout, plan, spaces, planes, flat, jobs);
        std::vector<double> distances = problem.verify(flat);
        std::vector<bool> isSpoiled(flat.size());
        for (std::size_t patch = 0; patch < flat.size(); ++patch)
            isSpoiled[patch] = distances[patch] > std::max(1.0, worse * round.distances[patch]);
        if (dropSpoiled(plan.stretches(), isSpoiled, planes)) continue;
        round.patches = std::move(flat);
        round.distances = std::move(distances);
        return;
    }
}

} // namespace qm
