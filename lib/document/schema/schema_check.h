/// \file Checking documents against schemas, with error messages in words.
#pragma once

#include "document/json/json_fwd.h"

#include <string>

namespace qm {

/// Checks a document against the schema of its kind.
/// \throw Error  with the JSON pointer of the first violation
void validateAgainstSchema(const Json& root, const std::string& kind);

/// Checks a value against any schema; for tests, and for schemas of schemas.
void validate(const Json& root, const Json& schema);

} // namespace qm
