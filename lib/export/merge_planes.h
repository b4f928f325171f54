/// \file Neighbouring plane faces that lie in one plane, merged into one face of any outline.
#pragma once

#include "export/boundary.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Takes the edges between such faces away, and the vertices that no edge needs any more. A merged face may
/// have holes; no vertex is on its outline twice, and it has a few hundred edges at most. It stands where the
/// first of its faces was.
/// \param origins  of every face, the segments that it is made of; merged likewise, ascending
/// \param boundary  faces have no holes yet
void mergePlanes(Boundary& boundary, std::vector<std::vector<std::size_t>>& origins);

} // namespace qm
