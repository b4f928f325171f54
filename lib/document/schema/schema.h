/// \file The schemas of the documents.
#pragma once

#include "document/json/json_fwd.h"

#include <string>

namespace qm {

/// The complete schema of a kind of document; its definitions include those it uses from other schemas.
/// \throw std::logic_error  if there is no such kind, or if a schema refers to a missing definition
[[nodiscard]] Json bundledSchema(const std::string& kind);

/// The same without its `$id`, so that nothing is fetched by that name.
[[nodiscard]] Json namelessSchema(const std::string& kind);

/// The whole schema as text.
[[nodiscard]] std::string standaloneSchema(const std::string& kind);

/// What a part of a schema refers to, or itself.
/// \param schema  the whole of it, such as `bundledSchema` makes
[[nodiscard]] const Json& referredTo(const Json& schema, const Json& part);

} // namespace qm
