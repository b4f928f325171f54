/// \file Does a front hold what it says of its layouts?
#pragma once

#include "check/checked_document.h"
#include "check/report.h"

namespace qm::check {

/// No layout of the front is as good as another in everything, none is below its bound, and what is said to
/// be proven attains it.
void checkFront(const LayoutPart& part, Report& report);

} // namespace qm::check
