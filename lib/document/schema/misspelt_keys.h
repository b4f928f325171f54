/// \file Unknown keys of a document that look like misspelt known keys.
#pragma once

#include "document/json/json.h"

#include <string>
#include <vector>

namespace qm {

/// One sentence, with the JSON pointer, for every unknown key that is at most two letters away from a known
/// key that is missing in the same object. All other unknown keys are allowed.
/// \param kind  of the document, such as "layout"
[[nodiscard]] std::vector<std::string> misspeltKeys(const Json& root, const std::string& kind);

} // namespace qm
