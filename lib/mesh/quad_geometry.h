/// \file Normals and areas of quads.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>

namespace qm {

/// A quad's vertices as the file lists them.
[[nodiscard]] std::array<VertexId, 4> cornersOf(const QuadMesh& mesh, FaceId face);

/// Of unit length, or zero for a triangle without area.
[[nodiscard]] Point triangleNormal(const Point& a, const Point& b, const Point& c);

/// The normals of a quad's two triangles, split along the diagonal from its first vertex.
[[nodiscard]] std::array<Point, 2> triangleNormals(const QuadMesh& mesh, FaceId face);

/// False if neither of its triangles has an area.
[[nodiscard]] bool hasArea(const QuadMesh& mesh, FaceId face);

/// Averages those of the two triangles; of unit length, or zero if there is none (docs/METHOD.md#cost).
[[nodiscard]] Point quadNormal(const QuadMesh& mesh, FaceId face);

} // namespace qm
