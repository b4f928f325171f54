/// \file Dividing polygons that have no middle from which all their corners are seen.
#pragma once

#include "mesh/soup/soup.h"
#include "remesh/polygons/grid_filling.h"

#include <cstddef>
#include <map>

namespace qm {

/// Polygons each of which can be divided into quads, by its grid if it has one, or else around its middle.
struct ConvexPieces {
    Soup soup;
    std::map<std::size_t, GridFilling> grids; ///< by polygon
};

/// Divides polygons so that each can be divided into quads, around its middle or by a grid (see
/// `isSeenFromItsMiddle`, `needsGrid`). The others are divided into triangles, and these joined to the best
/// quads; those that cross themselves stay as they are. No side is added that the surface has already.
/// Corners that repeat their neighbour are left out, and faces with fewer than three others.
/// \param soup  polygons with indices in range and finite coordinates
/// \return the same points, and the pieces in the order of their polygons
[[nodiscard]] ConvexPieces convexPieces(const Soup& soup);

} // namespace qm
