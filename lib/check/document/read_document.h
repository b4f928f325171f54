/// \file From JSON to the checker's view of a document: nothing behind it knows JSON.
#pragma once

#include "check/document/checked_document.h"

#include <nlohmann/json.hpp>

namespace qm::check {

/// Takes over every figure as it stands. Never fails, whatever the JSON is: what is missing or of another
/// type becomes a value that no check accepts, and a schema is the place to say so.
/// \param document  the whole of it
[[nodiscard]] CheckedDocument readDocument(const nlohmann::ordered_json& document);

} // namespace qm::check
