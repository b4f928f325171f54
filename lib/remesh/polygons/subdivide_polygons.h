/// \file Making quads of polygons by dividing every face around a point in its middle
/// (docs/METHOD.md#quads-of-polygons).
#pragma once

#include "mesh/soup/soup.h"

namespace qm {

/// One step of Catmull-Clark subdivision that leaves the vertices where they are: the points that are added,
/// one in every edge and one in every face, are those of the mesh whose step ends in them. Sharp edges stay
/// sharp (see `polygonEdges`). Faces that reach around their middle, or have corners in the middle of a side,
/// are divided into convex ones first (see `convexPieces`); round ones are filled with grids (see
/// `needsGrid`).
/// \param soup  polygons with indices in range and finite coordinates; corners that repeat their neighbour
/// are left out, and faces that have fewer than three others
/// \param rho  edges of larger dihedral angles are sharp, radians
/// \return quads; the vertices keep their numbers
/// \throw Error  if no face is left
[[nodiscard]] Soup subdividePolygons(const Soup& soup, double rho);

} // namespace qm
