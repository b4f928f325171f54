/// \file The fans of quads around the vertices of a soup.
#pragma once

#include "mesh/soup_edges.h"

#include <functional>
#include <span>
#include <vector>

namespace qm {

/// Visits every fan once: a maximal run of quads around a vertex, each beside the next. Open fans come first,
/// then those that are closed.
/// \param twins  of a consistently oriented soup (see `twinSides`)
/// \param visit  takes the corners of the fan, which are all at one vertex
void forEachFan(const std::vector<Side>& twins, const std::function<void(std::span<const Side>)>& visit);

/// Gives every fan but the first at its vertex a vertex of its own, at the same place, behind all others.
/// Vertices on edges of more than two quads are left alone.
/// \return how many vertices had several fans
std::size_t splitFans(Soup& soup);

} // namespace qm
