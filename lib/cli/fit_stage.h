/// \file What qm-bspline does between reading and writing.
#pragma once

#include "bspline/fit.h"
#include "cli/stage.h"

#include <string>
#include <vector>

namespace qm {

struct FitRequests {
    std::string reference;                 ///< file of a scan; empty: none
    bool rank = false;                     ///< the inputs are layouts of one mesh to choose from
    std::vector<std::string> furtherFiles; ///< besides the input
};

void declareRequests(Tool& tool, FitRequests& requests, const FitOptions& options);

/// Fits the input's layout, or the best of several, and writes its surfaces.
/// \return the exit status
[[nodiscard]] int fitAndWrite(const Tool& tool, Stage& stage, const FitOptions& options,
                              const FitRequests& requests);

} // namespace qm
