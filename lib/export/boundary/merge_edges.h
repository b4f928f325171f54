/// \file Merges edges that follow one another on one line, circle or ellipse.
#pragma once

#include "export/boundary/boundary.h"

namespace qm {

/// Two edges between the same faces become one where nothing else ends at their common vertex, if their
/// curves are the same line, circle or ellipse, and that does not become a closed edge.
/// \return whether there were any
bool mergeEdges(Boundary& boundary);

} // namespace qm
