/// \file JSON as used by documents: strict reading, readable writing.
#pragma once

#include "document/json/json_fwd.h"
#include "document/json/members.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace qm {

using JsonPointer = Json::json_pointer;

/// A value; null if there is none.
template <class Value> [[nodiscard]] Json valueOrNull(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

/// The value as a 64-bit integer if it is whole, however it is written; otherwise nothing.
[[nodiscard]] std::optional<std::int64_t> wholeNumber(const Json& value);

/// Reads a value, in time linear in the text even for objects with many keys.
/// \throw Error  with line and column, if the text is empty, no JSON or not UTF-8, has a key twice in one
/// object, or is nested more than 100 deep
[[nodiscard]] Json parseJson(std::string_view text);

/// A value that fits into 100 columns stands on one line. Longer lists of numbers are filled line by line;
/// everything else has one element per line, indented by two spaces. Numbers are the shortest that read back
/// the same.
/// \throw std::logic_error  if a number is not finite
[[nodiscard]] std::string printJson(const Json& value);

/// The same on a single line.
[[nodiscard]] std::string printJsonLine(const Json& value);

} // namespace qm
