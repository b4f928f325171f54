/// \file Merges neighbouring faces in one plane into one face of any outline.
#pragma once

#include "export/boundary.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Removes the edges between such faces, and the vertices that no edge needs any more. A merged face may have
/// holes; no vertex is on its outline twice, and it has a few hundred edges at most. It takes the place of
/// the first of its faces.
/// \param origins   by face: the segments that it consists of; merged likewise, ascending
/// \param boundary  its faces have no holes yet
/// \return whether there were any
bool mergePlanes(Boundary& boundary, std::vector<std::vector<std::size_t>>& origins);

} // namespace qm
