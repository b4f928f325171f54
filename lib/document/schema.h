/// \file The schemas of the documents, and validation against them.
#pragma once

#include <string>

namespace qm {

/// The schema of a kind of document, complete in itself: what it takes from common.schema.json is inside.
/// \throw Error  if there is no such kind
[[nodiscard]] std::string standaloneSchema(const std::string& kind);

} // namespace qm
