/// \file The first thing in a value that breaks a schema, as Valijson tells it. Reading a schema stands in a
/// source of its own, `schema_parse.cpp`, because both take long to compile.
#pragma once

#include "document/json_fwd.h"

#include <optional>
#include <string>
#include <vector>

namespace valijson {
class Schema;
}

namespace qm {

/// \param compiled  new; what the schema says is put into it
void parseSchema(const Json& schema, valijson::Schema& compiled);

struct SchemaViolation {
    /// The way from the root to the place: "[key]" or "[position among the shown elements]" for every step
    /// but the first, which is the root itself.
    std::vector<std::string> context;
    std::string description; ///< in Valijson's words
};

/// None if the value keeps to the schema.
[[nodiscard]] std::optional<SchemaViolation> firstViolation(const Json& root, const Json& schema);

} // namespace qm
