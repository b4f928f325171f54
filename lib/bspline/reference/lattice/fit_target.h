/// \file The reference that surfaces are fitted to and measured from.
#pragma once

#include "bspline/reference/lattice/reference_grid.h"

#include <vector>

namespace qm {

struct FitTarget {
    std::vector<ReferenceGrid> grids{}; ///< by segment
    /// By grid and point: at most 1, less where the scan has nothing and the point is guessed; empty if all
    /// are 1.
    std::vector<std::vector<double>> weights{};
    double coverage = 1;    ///< share of the points for which the scan has one
    double noise = 0;       ///< standard deviation of the scan from a smooth surface, estimated
    double maxDistance = 0; ///< farther parts of the scan are ignored
};

} // namespace qm
