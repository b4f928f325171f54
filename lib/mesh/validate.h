/// \file What a soup must be to become a quad mesh (docs/METHOD.md#words).
#pragma once

#include "mesh/soup_edges.h"

#include <array>

namespace qm {

/// What surfaces of any polygons need: at least one face, three sides or more, indices in range, coordinates
/// that are numbers and not too large to be squared.
/// \throw Error  naming the first offending face or vertex, with its line where there is one
void validatePolygons(const Soup& soup);

/// What cannot be mended: at least one face, quads only, indices in range, coordinates that are numbers
/// and not too large to be squared.
/// \throw Error  naming the first offending face or vertex, with its line where there is one
void validateElements(const Soup& soup);

/// The elements, then: no repeated vertex in a face, no face twice, at most two faces at an edge, consistent
/// orientation, one fan of faces at every vertex. Two quads back to back that close a component are no
/// duplicates.
/// \return for every side the one that runs the opposite way, or none on the boundary (see `twinSides`)
/// \throw Error  naming the first offending face, edge or vertex, with its line where there is one
std::vector<Side> validateSoup(const Soup& soup);

/// The corners of a quad in ascending order.
[[nodiscard]] std::array<std::int64_t, 4> sortedCorners(const Soup& soup, std::size_t face);

} // namespace qm
