/// \file The Pareto front of pruned layouts: those that no other one dominates
/// (docs/METHOD.md#pruning-program).
#pragma once

#include <cstddef>
#include <vector>

namespace qm {

/// The figures of a layout. One layout dominates another if its number of segments, its G_T and its captured
/// sharpness are all at least as good, up to rounding.
struct FrontPoint {
    double beta = 0; ///< price of a segment for which the layout was found
    std::size_t segments = 0;
    double cost = 0; ///< G_T
    double capturedSharpness = 0;
    double objectiveBound = 0; ///< no layout has a lower G_T + beta * segments
    bool proven = false;       ///< the layout attains the bound
};

/// Adds a point unless another one dominates it, and removes all points that the new one dominates.
/// \param front  no point of it dominates another
void addToFront(std::vector<FrontPoint>& front, const FrontPoint& point);

} // namespace qm
