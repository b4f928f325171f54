/// \file A report as people and programs read it.
#pragma once

#include "check/document/report.h"

#include <string>

namespace qm::check {

/// One line for each thing that was found true, and the verdict.
[[nodiscard]] std::string reportText(const Report& report);

/// An object with "ok", "verified", "violations" (those that were kept) and "violationCount", ending in a
/// line break.
[[nodiscard]] std::string reportJson(const Report& report);

/// The violations as lines without line breaks, `pointer: rule: explanation`: at most `max`, and one more
/// line that says how many there are if those are not all.
[[nodiscard]] std::vector<std::string> violationLines(const Report& report, std::size_t max);

} // namespace qm::check
