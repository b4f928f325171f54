/// \file Which patches move when plane patches are moved into their planes, and what holds them together.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/planes/flat_patches.h"
#include "bspline/solver/linear_form.h"
#include "bspline/splines/surfaces.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// Patches within so many of a plane patch move with it.
constexpr int ringsAroundPlanes = 2;

/// Moving patches that are joined by equations, and are not joined to others.
struct MovingGroup {
    std::vector<std::size_t> patches;
    std::vector<std::array<std::size_t, 2>> neighbours; ///< pairs that share a border, by place in `patches`
    std::size_t unknowns = 0;                           ///< number of control points
    std::vector<LinearForm> equations; ///< in the unknowns of the group's patches, one patch after the other
};

/// Divides the plane patches that are not in their planes and those within two patches of them into groups;
/// all others stay as they are.
/// \param flat     by patch: its plane, if it has one
/// \param patches  with the knots of the plan
[[nodiscard]] std::vector<MovingGroup> movingGroups(const KnotPlan& plan,
                                                    const std::vector<std::optional<FlatPatch>>& flat,
                                                    const std::vector<Patch>& patches);

} // namespace qm
