/// \file The schemas of the documents, and validation against them.
#pragma once

#include "document/json.h"

#include <string>

namespace qm {

/// The schema of a kind of document, complete in itself: what it takes from other schemas is among its
/// definitions.
/// \throw std::logic_error  if there is no such kind, or a schema refers to what does not exist
[[nodiscard]] Json bundledSchema(const std::string& kind);

/// The same as text.
[[nodiscard]] std::string standaloneSchema(const std::string& kind);

/// Checks a document against the schema of its kind.
/// \throw Error  with the JSON pointer of the first place that is wrong
void validateAgainstSchema(const Json& root, const std::string& kind);

/// Checks a value against any schema. For tests, and for schemas of schemas.
void validate(const Json& root, const Json& schema);

} // namespace qm
