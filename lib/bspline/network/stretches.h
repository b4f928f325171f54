/// \file Stretches: where one side of a patch runs along one side of another.
#pragma once

#include "bspline/network/borders.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Where a stretch lies on a side of a patch: the stretch's parameter x, counted in mesh edges from its
/// beginning, belongs to `origin + direction * x` of the side, counted from the side's beginning.
struct StretchSide {
    std::size_t patch = 0;
    int side = 0;
    int origin = 0;
    /// 1 for the first side, -1 for the second, which sees the stretch the other way round.
    int direction = 1;
};

/// A maximal run of border edges shared by one side of each of two patches, which may be the same patch.
/// Sides fall into several stretches where other patches meet at T-joints.
struct Stretch {
    std::array<StretchSide, 2> sides;
    std::vector<HalfedgeId> halfedges; ///< in the direction of the first side

    [[nodiscard]] int length() const { return static_cast<int>(halfedges.size()); }
};

/// The patch's parameter along its side at a parameter of the stretch.
[[nodiscard]] double patchParameter(const std::array<int, 2>& size, const StretchSide& place, double x);

/// The patch's parameters (u, v) there.
[[nodiscard]] std::array<double, 2> patchPlace(const std::array<int, 2>& size, const StretchSide& place,
                                               double x);

/// The parameter of the stretch at a parameter of the patch along its side.
[[nodiscard]] double stretchParameter(const std::array<int, 2>& size, const StretchSide& place,
                                      double parameter);

/// All stretches, in the order of the first patch, side and position that has them.
[[nodiscard]] std::vector<Stretch> findStretches(const std::vector<BorderEdge>& borders);

/// Adds to a set of patches those that share a border with one of them, `rings` times.
[[nodiscard]] std::vector<bool> withNeighbours(const std::vector<Stretch>& stretches,
                                               std::vector<bool> patches, int rings);

} // namespace qm
