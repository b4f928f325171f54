/// \file The first thing in a value that breaks a schema, as Valijson tells it.
#pragma once

#include "document/json.h"

#include <optional>
#include <string>
#include <vector>

namespace qm {

struct SchemaViolation {
    /// The way from the root to the place: "[key]" or "[position among the shown elements]" for every step
    /// but the first, which is the root itself.
    std::vector<std::string> context;
    std::string description; ///< in Valijson's words
};

/// None if the value keeps to the schema.
[[nodiscard]] std::optional<SchemaViolation> firstViolation(const Json& root, const Json& schema);

} // namespace qm
