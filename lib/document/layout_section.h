/// \file The section `layout`.
#pragma once

#include "document/json_place.h"
#include "layout/layout.h"
#include "merge/merge.h"
#include "prune/prune.h"

namespace qm {

/// Tracks, segments, costs and figures of quality.
/// \param rho  above this dihedral angle an edge counts as sharp, radians
[[nodiscard]] Json layoutToJson(const QuadMesh& mesh, const Layout& layout,
                                const std::vector<double>& dihedralAngles, double rho);

/// Figures of the tools, for the section's keys `merge` and `prune`.
[[nodiscard]] Json mergeFigures(const MergeResult& result);
[[nodiscard]] Json pruneFigures(const PruneResult& result);

/// Tracks may have been edited. They are the truth: segments are made anew from them, and those that are
/// given must agree. Costs that are given must be what the edges add up to.
[[nodiscard]] Layout readLayout(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                                const std::vector<double>& edgeCosts, const JsonPlace& section);

/// Whether the section says all that `layoutToJson` would, in the same words.
[[nodiscard]] bool layoutIsWhole(const QuadMesh& mesh, const Layout& layout, const Json& section);

} // namespace qm
