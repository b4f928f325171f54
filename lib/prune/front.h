/// \file What can be had for how many segments: layouts of which none is as good as another in everything
/// (docs/METHOD.md#pruning-program).
#pragma once

#include <cstddef>
#include <vector>

namespace qm {

/// A layout by its figures. One is as good as another if its segments, its G_T and its captured sharpness all
/// are, but for rounding of the costs.
struct FrontPoint {
    double beta = 0; ///< the price of a segment at which it was found
    std::size_t segments = 0;
    double cost = 0; ///< G_T
    double capturedSharpness = 0;
    double objectiveBound = 0; ///< no layout has a lower G_T + beta * segments
    bool proven = false;       ///< it attains the bound
};

/// Adds a point unless one of the front is as good; it takes the place of all that it is as good as.
/// \param front  no point is as good as another
void addToFront(std::vector<FrontPoint>& front, const FrontPoint& point);

} // namespace qm
