/// \file Are these feature curves and seeds? (docs/METHOD.md#features)
#pragma once

#include "check/checked_document.h"
#include "check/neighbourhoods.h"
#include "check/report.h"

#include <vector>

namespace qm::check {

/// Curves may have been added by hand, so only what later stages rest on is asked for: each runs along one
/// mesh line, and its seed is a regular interior vertex of it and no other curve's seed.
///
/// \return  for every sound seed a step from it along its curve
[[nodiscard]] std::vector<int> checkFeatures(const Neighbourhoods& around, const FeaturesPart& part,
                                             Report& report);

} // namespace qm::check
