/// \file The section `layout`.
#pragma once

#include "document/json/json_place.h"
#include "layout/layout.h"
#include "merge/merge.h"
#include "prune/prune.h"

namespace qm {

/// Writes tracks, segments, costs and figures of quality.
/// \param rho  edges with larger dihedral angles count as sharp, radians
[[nodiscard]] Json layoutToJson(const QuadMesh& mesh, const Layout& layout,
                                const std::vector<double>& dihedralAngles, double rho);

/// The tools' figures, for the keys `merge` and `prune` of the section.
[[nodiscard]] Json mergeFigures(const MergeResult& result);
[[nodiscard]] Json pruneFigures(const PruneResult& result);

/// Reads a layout. Tracks may have been edited and are authoritative: segments are made anew from them, and
/// the section's segments, if present, must agree. Costs in the section must equal the sums over edges.
[[nodiscard]] Layout readLayout(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                                const std::vector<double>& edgeCosts, const JsonPlace& section);

/// Whether the section contains everything that `layoutToJson` would write, in the same form.
[[nodiscard]] bool layoutIsWhole(const QuadMesh& mesh, const Layout& layout, const Json& section);

} // namespace qm
