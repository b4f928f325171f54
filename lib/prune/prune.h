/// \file Removing flat boundaries (method 8; paper 5).
#pragma once

#include "base/control.h"
#include "merge/layout.h"

namespace qm {

struct PruneOptions {
    double eta = 1;      ///< tracks that cost more than this are removed; -3 suits soft models
    bool smooth = true;  ///< apply the smoothness criterion
    double maxTurn = 25; ///< P, degrees: the most that the boundary may turn where a removed track ended
};

struct PruneResult {
    Layout layout;
    std::size_t removedTracks = 0;
    std::size_t keptNotQuadrilateral = 0; ///< candidates kept because a segment would lose its four corners
    std::size_t keptNotSmooth = 0;        ///< candidates kept because of the smoothness criterion
};

/// Greedy: candidates in decreasing order of cost, ties by id; a track goes if every segment stays a grid
/// with four corners. A removal may free a track that ended there or was crossed, so candidates are gone
/// through in the same order until none goes any more. Transversals are no candidates; an annulus stays one.
/// The test of one track takes time linear in its length and looks at its own vertices only.
/// \param layout  as `buildLayout` makes it
[[nodiscard]] PruneResult pruneLayout(const QuadMesh& mesh, const Layout& layout,
                                      const std::vector<double>& dihedralAngles,
                                      const std::vector<double>& edgeCosts, const PruneOptions& options,
                                      const Control& control = {});

} // namespace qm
