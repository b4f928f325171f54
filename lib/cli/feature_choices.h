/// \file What the options of qm-features mean together.
#pragma once

#include "features/features.h"

#include <string>

namespace qm {

class Tool;

/// Where limits are given in edges alone, as in the paper, those in lengths do not apply; and `--min-angle`
/// sets `--rho`.
/// \param minAngle  "25" or "25deg"; empty if it was not given
/// \throw UsageError  if the angle is none from 0 to 180, or was given twice
void settleFeatureOptions(const Tool& tool, const std::string& minAngle, FeatureOptions& options);

} // namespace qm
