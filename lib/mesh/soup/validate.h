/// \file The conditions for turning a soup into a quad mesh (docs/METHOD.md#words).
#pragma once

#include "mesh/soup/soup_edges.h"

#include <array>

namespace qm {

/// Checks what surfaces of any polygons need: at least one face, at least three sides per face, indices in
/// range, coordinates that are finite and small enough to be squared.
/// \throw Error  with the first offending face or vertex, and its line if there are lines
void validatePolygons(const Soup& soup);

/// Checks what cannot be repaired: at least one face, quads only, indices in range, coordinates that are
/// finite and small enough to be squared.
/// \throw Error  with the first offending face or vertex, and its line if there are lines
void validateElements(const Soup& soup);

/// Checks the elements, and then: no repeated vertex in a face, no duplicate faces, at most two faces at an
/// edge, consistent orientation, one fan of faces at every vertex. Two quads back to back that form a closed
/// component are no duplicates.
/// \return for every side, the opposite one on the same edge; none on the boundary (see `twinSides`)
/// \throw Error  with the first offending face, edge or vertex, and its line if there are lines
std::vector<Side> validateSoup(const Soup& soup);

/// The corners of a quad in ascending order.
[[nodiscard]] std::array<std::int64_t, 4> sortedCorners(const Soup& soup, std::size_t face);

} // namespace qm
