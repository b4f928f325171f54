/// \file Edges in two parts.
#pragma once

#include "export/boundary/boundary.h"

#include <optional>
#include <vector>

namespace qm {

/// Divides edges at new vertices, in all outlines that they are part of.
/// \param at  by edge: the parameter where it is divided, if it is
/// \return whether there was one
bool divideEdges(Boundary& boundary, const std::vector<std::optional<double>>& at);

} // namespace qm
