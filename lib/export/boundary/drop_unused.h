/// \file Removes what is no longer needed from the lists of a boundary.
#pragma once

#include "export/boundary/boundary.h"

namespace qm {

/// Drops edges that no face uses, and vertices without edges.
void dropUnused(Boundary& boundary);

} // namespace qm
