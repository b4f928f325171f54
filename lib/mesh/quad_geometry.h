/// \file Normals and areas of quads, and lengths of edges.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>
#include <optional>

namespace qm {

/// The vertices of a quad in the order of the file.
[[nodiscard]] std::array<VertexId, 4> cornersOf(const QuadMesh& mesh, FaceId face);

/// Their places.
[[nodiscard]] std::array<Point, 4> cornerPoints(const QuadMesh& mesh, FaceId face);

using Triangle = std::array<Point, 3>;

/// The unit normal of a triangle; none for a triangle without area.
[[nodiscard]] std::optional<Point> triangleNormal(const Triangle& triangle);

/// The two triangles of a quad, split along the diagonal from its first vertex.
[[nodiscard]] std::array<Triangle, 2> halvesOf(const QuadMesh& mesh, FaceId face);

/// Whether at least one of the quad's two triangles has an area.
[[nodiscard]] bool hasArea(const QuadMesh& mesh, FaceId face);

/// The normalised sum of the unit normals of a quad's triangles; none if both have no area
/// (docs/METHOD.md#cost).
[[nodiscard]] std::optional<Point> quadNormal(const QuadMesh& mesh, FaceId face);

/// The unit normal in the middle of a quad, the product of its diagonals, in which all four corners count
/// alike.
[[nodiscard]] std::optional<Point> middleNormal(const QuadMesh& mesh, FaceId face);

/// The smallest sine of the angles at a quad's corners, seen along the normal in its middle: 1 for a
/// rectangle, 0 where three corners lie in a line or two in one place, negative where a corner is turned
/// over. None if there is no such normal.
[[nodiscard]] std::optional<double> minCornerSine(const QuadMesh& mesh, FaceId face);

/// Whether some corner is within 6 degrees of flat or of nothing, is turned over against the quad's middle,
/// or has no area. The dihedral angles of such a quad are unreliable: remeshers divide triangles into quads
/// with three corners in a line, where rounding determines the normal. At a vertex of many edges corners may
/// be narrower.
[[nodiscard]] bool isFolded(const QuadMesh& mesh, FaceId face);

/// The mean length of all edges; 0 if there are none.
[[nodiscard]] double meanEdgeLength(const QuadMesh& mesh);

} // namespace qm
