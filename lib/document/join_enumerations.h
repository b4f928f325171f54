/// \file Joining the partial documents of several runs of a search.
#pragma once

#include "document/document.h"

#include <vector>

namespace qm {

/// The document that a single run over all sub-meshes would have written, byte by byte.
/// \param parts  documents of kind enumeration that have a `part`, in any order
/// \throw FileError  if one has no part or differs from the first in more than its findings, or one is
/// missing
[[nodiscard]] Document joinEnumerations(std::vector<Document> parts);

} // namespace qm
