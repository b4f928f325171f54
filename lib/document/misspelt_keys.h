/// \file Keys of a document that no tool reads, but that look like one that is read.
#pragma once

#include "document/json.h"

#include <string>
#include <vector>

namespace qm {

/// A sentence with the JSON pointer for every key that the schema does not know and that is at most two
/// letters from one that it knows and that is missing there. Other keys are people's own.
/// \param kind  of the document, such as "layout"
[[nodiscard]] std::vector<std::string> misspeltKeys(const Json& root, const std::string& kind);

} // namespace qm
