/// \file The history of a document: which tools have made it (schemas/FORMAT.md).
#pragma once

#include "check/document/report.h"

#include <nlohmann/json.hpp>

namespace qm::check {

/// \param root  the whole document
[[nodiscard]] bool wasPruned(const nlohmann::ordered_json& root);

/// Reports a history that cannot have led to this document: tools of the pipeline out of order, or another
/// than the one that makes its kind at the end. Tools of other names may have worked on it, too.
void checkHistory(const nlohmann::ordered_json& root, Report& report);

} // namespace qm::check
