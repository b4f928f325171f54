/// \file Removing flat boundaries (docs/METHOD.md#pruning).
#pragma once

#include "base/control.h"
#include "base/infinity.h"
#include "layout/constraints.h"
#include "layout/layout.h"
#include "prune/pruned_mesh.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

enum class PruneMethod {
    greedy, ///< the paper's method: whole tracks, the most expensive first
    optimum ///< the cheapest layout of grids, with a proof if there is time
};

struct PruneOptions {
    PruneMethod method = PruneMethod::greedy;
    double eta = 1;      ///< greedy: tracks that cost more than this are candidates; -3 suits soft models
    bool smooth = true;  ///< whether the smoothness criterion applies
    double maxTurn = 25; ///< P, degrees: the largest turn of the boundary where a removed track ended
    /// Smallest angle, in degrees, of a corner beside a side that passes straight through an extraordinary
    /// vertex.
    double minCorner = 25;
    /// Degrees: where a track ends on a line of sharp edges that turns by more, it is continued first. At
    /// 180, or without the smoothness criterion, no tracks are added at all, see `prune`.
    double maxSharpTurn = 35;
    double beta = 1; ///< optimum: price of a segment
    /// Optimum: minimises the number of segments first and G_T second; beta is not used.
    bool fewestPatches = false;
    /// Optimum: the largest number of segments, whatever their cost; beta is not used.
    double maxSegments = infinity;
    double timeLimit = 60; ///< optimum and front: seconds in total
    bool front = false;    ///< whether to find the front of layouts
    Constraints constraints;
};

/// The figures of a layout on the Pareto front (docs/METHOD.md#pruning-program). One layout dominates another
/// if its number of segments, its G_T and its captured sharpness are all at least as good, up to rounding.
struct FrontPoint {
    double beta = 0; ///< price of a segment for which the layout was found
    std::size_t segments = 0;
    double cost = 0; ///< G_T
    double capturedSharpness = 0;
    double objectiveBound = 0; ///< no layout has a lower G_T + beta * segments
    bool proven = false;       ///< the layout attains the bound
};

struct PruneResult {
    Layout layout;
    std::size_t addedTracks = 0;          ///< see `prune`
    std::size_t removedTracks = 0;        ///< greedy, which removes whole tracks; likewise below
    std::size_t keptNotQuadrilateral = 0; ///< candidates kept because a segment would lose its four corners
    std::size_t keptNotSmooth = 0;        ///< candidates kept because of the smoothness criterion
    /// Optimum: G_T + beta * segments. If the number of segments is limited, G_T; if it is minimised, the
    /// number. Of the layout to which no tracks were added yet.
    std::optional<double> objective;
    std::optional<double> objectiveBound; ///< optimum: of no layout is the objective lower
    bool proven = false;                  ///< optimum: whether the objective attains the bound
    std::vector<FrontPoint> front;        ///< if asked for
};

/// Greedy: candidates in decreasing order of cost, ties by id; a track is removed if every segment stays a
/// grid with four corners. A removal may make others possible, so candidates are tried again in the same
/// order until none can be removed. Transversals and tracks with required edges are no candidates, and annuli
/// stay annuli. The test of a track looks at its own vertices only, in time linear in its length.
/// \param layout  as made by `buildLayout`
[[nodiscard]] PruneResult pruneLayout(const PrunedMesh& pruned, const Layout& layout,
                                      const PruneOptions& options, const Control& control = {});

/// Adds a point unless another one dominates it, and removes all points that the new one dominates.
/// \param front  no point of it dominates another
void addToFront(std::vector<FrontPoint>& front, const FrontPoint& point);

} // namespace qm
