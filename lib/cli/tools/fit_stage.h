/// \file The work of qm-bspline between reading and writing.
#pragma once

#include "bspline/fit.h"
#include "cli/stage.h"

#include <string>
#include <vector>

namespace qm {

struct FitRequests {
    std::string reference;                 ///< file of a scan; empty if there is none
    bool rank = false;                     ///< whether the inputs are layouts of one mesh to choose from
    std::vector<std::string> furtherFiles; ///< inputs after the first
};

void declareRequests(Tool& tool, FitRequests& requests, const FitOptions& options);

/// Fits surfaces to the input's layout, or to the best of several, and writes them.
/// \return the exit status
[[nodiscard]] int fitAndWrite(const Tool& tool, Stage& stage, const FitOptions& options,
                              const FitRequests& requests);

} // namespace qm
