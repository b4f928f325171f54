/// \file What a soup must be to become a quad mesh (method 1).
#pragma once

#include "mesh/soup.h"

namespace qm {

/// Checks, in this order: at least one face, quads only, indices in range, finite coordinates, no repeated
/// vertex in a face, no face twice, at most two faces at an edge, consistent orientation, one fan of faces at
/// every vertex. \throw Error  naming the first offending face, edge or vertex, with its line where there is
/// one
void validateSoup(const Soup& soup);

/// The first three checks and the fourth: what repair cannot mend.
void validateElements(const Soup& soup);

} // namespace qm
