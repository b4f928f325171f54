/// \file Taking faces and vertices out of a soup.
#pragma once

#include "mesh/soup.h"

#include <vector>

namespace qm {

/// Keeps the faces whose entry is true, in their order.
/// \return how many went
std::size_t keepFaces(Soup& soup, const std::vector<bool>& kept);

/// Replaces every vertex k by vertex `target[k]`, which is not above k and its own target. Replaced ones
/// go; the others move up in their order.
/// \return how many went
std::size_t mergePoints(Soup& soup, const std::vector<std::size_t>& target);

} // namespace qm
