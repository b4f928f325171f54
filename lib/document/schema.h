/// \file The schemas of the documents.
#pragma once

#include "document/json_fwd.h"

#include <string>
#include <string_view>

namespace qm {

/// Begins a reference to a definition in the same schema.
inline constexpr std::string_view localReference = "#/definitions/";

/// The schema of a kind of document, complete in itself: what it takes from other schemas is among its
/// definitions.
/// \throw std::logic_error  if there is no such kind, or a schema refers to what does not exist
[[nodiscard]] Json bundledSchema(const std::string& kind);

/// The same without its `$id`: nothing is to be fetched by that name.
[[nodiscard]] Json namelessSchema(const std::string& kind);

/// The whole schema as text.
[[nodiscard]] std::string standaloneSchema(const std::string& kind);

} // namespace qm
