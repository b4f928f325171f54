/// \file From JSON to the checker's view of a document. The only place of this module that knows JSON.
#pragma once

#include "check/checked_document.h"
#include "check/report.h"

#include <nlohmann/json.hpp>

namespace qm::check {

/// Takes over every figure as it stands. Never fails, whatever the JSON is: what is missing or of another
/// type becomes a value that no check accepts, and a schema is the place to say so.
///
/// \param root  the whole document
[[nodiscard]] CheckedDocument readDocument(const nlohmann::ordered_json& root);

/// Reports a history that cannot have led to this document: tools of the pipeline out of order, or another
/// than the one that makes its kind at the end. Tools of other names may have had their hands in it.
void checkHistory(const nlohmann::ordered_json& root, Report& report);

} // namespace qm::check
