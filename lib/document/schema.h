/// \file The schemas of the documents.
#pragma once

#include "document/json_fwd.h"

#include <string>
#include <string_view>

namespace qm {

/// The beginning of a reference to a definition in the same schema.
inline constexpr std::string_view localReference = "#/definitions/";

/// The complete schema of a kind of document; its definitions include those it uses from other schemas.
/// \throw std::logic_error  if there is no such kind, or if a schema refers to a missing definition
[[nodiscard]] Json bundledSchema(const std::string& kind);

/// The same without its `$id`, so that nothing is fetched by that name.
[[nodiscard]] Json namelessSchema(const std::string& kind);

/// The whole schema as text.
[[nodiscard]] std::string standaloneSchema(const std::string& kind);

} // namespace qm
