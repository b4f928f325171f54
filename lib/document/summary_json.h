/// \file The figures of a summary as JSON, and the options they depend on.
#pragma once

#include "document/json/json_place.h"
#include "summary/summary.h"

#include <optional>
#include <string>
#include <vector>

namespace qm {

/// The options of the fit according to a document's history; the defaults if it has no fit.
[[nodiscard]] FitOptions recordedFit(const JsonPlace& history);

/// \param name, unit, seconds  as for `summaryText`
/// \param unmet  the sentences of `unmetLimits`
[[nodiscard]] Json summaryToJson(const Summary& summary, const std::string& name, const std::string& unit,
                                 std::optional<double> seconds, const std::vector<std::string>& unmet);

} // namespace qm
