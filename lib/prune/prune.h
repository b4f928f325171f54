/// \file Removing flat boundaries (docs/METHOD.md#pruning).
#pragma once

#include "base/control.h"
#include "layout/layout.h"
#include "prune/front.h"

#include <limits>
#include <optional>
#include <vector>

namespace qm {

enum class PruneMethod {
    greedy, ///< the paper's: whole tracks, the most expensive first
    optimum ///< the cheapest layout of grids, proven if there is time
};

struct PruneOptions {
    PruneMethod method = PruneMethod::greedy;
    double eta = 1;      ///< greedy: tracks that cost more than this are removed; -3 suits soft models
    bool smooth = true;  ///< apply the smoothness criterion
    double maxTurn = 25; ///< P, degrees: the most that the boundary may turn where a removed track ended
    /// Degrees that a corner keeps beside a side that passes straight through an extraordinary vertex.
    double minCorner = 25;
    double beta = 1; ///< optimum: the price of a segment
    /// optimum: as few segments as can be, and only then the lowest G_T; then beta does not count
    bool fewestPatches = false;
    /// optimum: at most so many segments, whatever they cost; then beta does not count
    double maxSegments = std::numeric_limits<double>::infinity();
    double timeLimit = 60; ///< optimum and front: seconds for all together
    bool front = false;    ///< list what can be had for how many segments
};

struct PruneResult {
    Layout layout;
    std::size_t removedTracks = 0;
    std::size_t keptNotQuadrilateral = 0; ///< candidates kept because a segment would lose its four corners
    std::size_t keptNotSmooth = 0;        ///< candidates kept because of the smoothness criterion
    /// Optimum: no layout has a lower G_T + beta * segments; or a lower G_T, if the number of segments is
    /// limited; or a lower number, if that is to be as low as can be.
    std::optional<double> objectiveBound;
    bool proven = false;           ///< optimum: the layout attains the bound
    std::vector<FrontPoint> front; ///< if asked for
};

/// Greedy: candidates in decreasing order of cost, ties by id; a track goes if every segment stays a grid
/// with four corners. A removal may make others possible, so candidates are tried again in the same order
/// until none can be removed any more. Transversals are no candidates, and an annulus stays one. The test of
/// one track takes time linear in its length and looks at its own vertices only.
/// \param layout  as `buildLayout` makes it
[[nodiscard]] PruneResult pruneLayout(const QuadMesh& mesh, const Layout& layout,
                                      const std::vector<double>& dihedralAngles,
                                      const std::vector<double>& edgeCosts, const PruneOptions& options,
                                      const Control& control = {});

} // namespace qm
