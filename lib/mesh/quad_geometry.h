/// \file Normals and areas of quads, and lengths of edges.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>
#include <optional>

namespace qm {

/// A quad's vertices as the file lists them.
[[nodiscard]] std::array<VertexId, 4> cornersOf(const QuadMesh& mesh, FaceId face);

/// Of unit length; none for a triangle without area.
[[nodiscard]] std::optional<Point> triangleNormal(const Point& a, const Point& b, const Point& c);

/// The normals of a quad's two triangles, split along the diagonal from its first vertex.
[[nodiscard]] std::array<std::optional<Point>, 2> triangleNormals(const QuadMesh& mesh, FaceId face);

/// False if neither of its triangles has an area.
[[nodiscard]] bool hasArea(const QuadMesh& mesh, FaceId face);

/// The mean of those of its triangles, of unit length; none if both have no area (docs/METHOD.md#cost).
[[nodiscard]] std::optional<Point> quadNormal(const QuadMesh& mesh, FaceId face);

/// In the quad's middle, where the four corners count alike: the product of its diagonals, of unit length.
[[nodiscard]] std::optional<Point> middleNormal(const QuadMesh& mesh, FaceId face);

/// Whether a corner is within 6 degrees of flat, or turned over against the quad's middle, or without area.
/// What dihedral angles such a quad has is left to chance: remeshers divide triangles into quads with three
/// corners in a line, and rounding then decides on the normal between these.
[[nodiscard]] bool isFolded(const QuadMesh& mesh, FaceId face);

/// Of all edges; 0 if there are none.
[[nodiscard]] double meanEdgeLength(const QuadMesh& mesh);

} // namespace qm
