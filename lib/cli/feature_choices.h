/// \file What the options of qm-features mean together.
#pragma once

#include "features/features.h"

#include <string>

namespace qm {

class Tool;

/// Limits that are given in edges alone, as in the paper, are no lengths too; and `--min-angle` is `--rho`.
/// \param minAngle  "25" or "25deg"; empty if it was not given
/// \throw UsageError  if the angle is none from 0 to 180, or was given twice
void settleFeatureOptions(const Tool& tool, const std::string& minAngle, FeatureOptions& options);

} // namespace qm
