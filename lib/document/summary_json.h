/// \file The figures of a summary as JSON, and what they need of a document.
#pragma once

#include "document/json_place.h"
#include "summary/summary.h"

#include <optional>
#include <string>
#include <vector>

namespace qm {

/// The options of the fit that a document's history names; the defaults if it names none.
[[nodiscard]] FitOptions recordedFit(const JsonPlace& history);

/// \param name, unit, seconds  as of `summaryText`
/// \param unmet  sentences of `unmetLimits`
[[nodiscard]] Json summaryToJson(const Summary& summary, const std::string& name, const std::string& unit,
                                 std::optional<double> seconds, const std::vector<std::string>& unmet);

} // namespace qm
