/// \file The first violation of a schema, as reported by Valijson. Reading a schema is in a source of its
/// own, `schema_parse.cpp`, because both are slow to compile.
#pragma once

#include "document/json/json_fwd.h"

#include <optional>
#include <string>
#include <vector>

namespace valijson {
class Schema;
}

namespace qm {

/// \param compiled  a new schema, to be filled
void parseSchema(const Json& schema, valijson::Schema& compiled);

struct SchemaViolation {
    /// The path from the root to the place: "[key]" or "[position among the shown elements]" for every step
    /// except the first, which is the root itself.
    std::vector<std::string> context;
    std::string description; ///< in Valijson's words
};

/// The first violation; nothing if the value conforms to the schema.
[[nodiscard]] std::optional<SchemaViolation> firstViolation(const Json& root, const Json& schema);

} // namespace qm
