#include "bspline/fitting/planes/moving_groups.h"

#include "base/disjoint_sets.h"
#include "bspline/fitting/planes/plane_demands.h"
#include "bspline/fitting/system/continuity_equations.h"
#include "bspline/network/stretches.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

std::vector<bool> movingPatches(const KnotPlan& plan, const std::vector<std::optional<FlatPatch>>& flat,
                                const std::vector<Patch>& patches) {
    double largest = 0;
    for (const Patch& patch : patches)
        for (const Point& point : patch.controlPoints)
            largest = std::max(largest, point.max_abs());
    std::vector<bool> moves(flat.size());
    for (std::size_t k = 0; k < flat.size(); ++k)
        moves[k] = flat[k] && !isFlat(patches[k], *flat[k], planePrecision * largest);
    return withNeighbours(plan.stretches(), std::move(moves), ringsAroundPlanes);
}

/// Divides the patches that move into groups without equations yet.
/// \return by patch: its group; patches that stay have none
std::vector<std::size_t> groupPatches(const KnotPlan& plan, const std::vector<PatchSpace>& spaces,
                                      const std::vector<bool>& moves, std::vector<MovingGroup>& groups) {
    DisjointSets joined(spaces.size());
    for (const Stretch& stretch : plan.stretches())
        if (moves[stretch.sides[0].patch] && moves[stretch.sides[1].patch])
            joined.join(stretch.sides[0].patch, stretch.sides[1].patch);
    std::vector<std::size_t> groupOf(spaces.size());
    std::vector<std::size_t> placeOf(spaces.size());
    for (const auto& patches : joined.members()) {
        if (!moves[patches.front()]) continue;
        MovingGroup& group = groups.emplace_back();
        for (const std::size_t patch : patches) {
            groupOf[patch] = groups.size() - 1;
            placeOf[patch] = group.patches.size();
            group.patches.push_back(patch);
            group.unknowns += spaces[patch].size();
        }
    }
    for (const Stretch& stretch : plan.stretches()) {
        const std::size_t one = stretch.sides[0].patch;
        const std::size_t other = stretch.sides[1].patch;
        if (moves[one] && moves[other])
            groups[groupOf[one]].neighbours.push_back({placeOf[one], placeOf[other]});
    }
    return groupOf;
}

} // namespace

std::vector<MovingGroup> movingGroups(const KnotPlan& plan, const std::vector<std::optional<FlatPatch>>& flat,
                                      const std::vector<Patch>& patches) {
    const std::vector<bool> moves = movingPatches(plan, flat, patches);
    const std::vector<PatchSpace> spaces = plan.spaces();
    std::vector<MovingGroup> groups;
    const std::vector<std::size_t> groupOfPatch = groupPatches(plan, spaces, moves, groups);
    // By moving unknown: its group, and its number within the group.
    std::vector<std::size_t> groupOf;
    std::vector<std::size_t> ofGroup;
    std::vector<std::size_t> next(groups.size());
    for (std::size_t patch = 0; patch < spaces.size(); ++patch)
        for (std::size_t k = 0; moves[patch] && k < spaces[patch].size(); ++k) {
            groupOf.push_back(groupOfPatch[patch]);
            ofGroup.push_back(next[groupOfPatch[patch]]++);
        }
    const FreeUnknowns moving(spaces, moves);
    for (const LinearForm& equation : continuityEquations(plan, spaces, moves)) {
        LinearForm form = moving.among(equation);
        if (form.unknowns.empty()) continue;
        MovingGroup& group = groups[groupOf[form.unknowns.front()]];
        for (std::size_t& unknown : form.unknowns)
            unknown = ofGroup[unknown];
        group.equations.push_back(std::move(form));
    }
    return groups;
}

} // namespace qm
