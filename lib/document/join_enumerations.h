/// \file One document from the parts that several runs of a search have made.
#pragma once

#include "document/document.h"

#include <vector>

namespace qm {

/// The document that one run would have written for all sub-meshes, to the byte.
/// \param parts  of kind enumeration with a `part`, in any order
/// \throw FileError  if one is no part, or differs from the first in more than what was found, or one is missing
[[nodiscard]] Document joinEnumerations(std::vector<Document> parts);

} // namespace qm
