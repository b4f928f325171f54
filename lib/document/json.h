/// \file JSON as the documents use it: reading strictly, writing for people.
#pragma once

#include "document/json_fwd.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace qm {

using JsonPointer = Json::json_pointer;

/// Time linear in the text, also for objects with many keys.
/// \throw Error  at line and column: if the text is empty or no JSON, is not UTF-8, has a key twice in one
/// object, or is nested more than 100 deep
[[nodiscard]] Json parseJson(std::string_view text);

/// Whatever fits in 100 columns stands on one line; lists of numbers that do not are filled line by line, all
/// else has one element per line, indented by two blanks. Numbers are the shortest that read back the same.
/// \throw std::logic_error  if a number is not finite
[[nodiscard]] std::string printJson(const Json& value);

/// The same without line breaks at all.
[[nodiscard]] std::string printJsonLine(const Json& value);

} // namespace qm
