/// \file Are a layout's figures of quality right?
#pragma once

#include "check/angles.h"
#include "check/checked_document.h"
#include "check/report.h"

#include <span>

namespace qm::check {

/// Checks every figure that is given.
/// \param part     with sound segments
/// \param onTrack  by edge
void checkQuality(const Neighbourhoods& around, const Angles& angles, std::span<const char> onTrack,
                  const LayoutPart& part, Report& report);

} // namespace qm::check
