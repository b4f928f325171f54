/// \file The combined effect of qm-features' options.
#pragma once

#include "features/features.h"

#include <string>

namespace qm {

class Tool;

/// Limits in edges alone, as in the paper, switch off those in lengths and of roundness; `--min-angle` sets
/// `--rho`.
/// \param minAngle  "25" or "25deg"; empty if not given
/// \throw UsageError  if the angle is not from 0 to 180, or was given by both options
void settleFeatureOptions(const Tool& tool, const std::string& minAngle, FeatureOptions& options);

} // namespace qm
