/// \file Writing polygons in the formats that can be read.
#pragma once

#include "mesh/files/mesh_format.h"
#include "mesh/soup/soup.h"
#include "mesh/triangles/triangles.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace qm {

/// OBJ and OFF are text whose coordinates have the fewest digits that read back exactly; PLY is binary with
/// double precision; STL is binary with single precision.
/// \param soup  indices must be in range; for STL all polygons must be triangles
[[nodiscard]] std::string writeSoup(const Soup& soup, MeshFormat format);

/// The beginning of an OBJ or PLY file with all points, and a face that follows, for writers that have more
/// to say of faces.
/// \param furtherProperties  of a face, as lines of the header; their values follow each face
[[nodiscard]] std::string objPoints(const Soup& soup);
void appendObjFace(std::string& text, std::span<const std::int64_t> corners);
[[nodiscard]] std::string plyPoints(const Soup& soup, std::string_view furtherProperties = {});
void appendPlyFace(std::string& bytes, std::span<const std::int64_t> corners);

/// The faces of a mesh with its numbering; each begins with its first vertex.
[[nodiscard]] Soup soupOf(const QuadMesh& mesh);
[[nodiscard]] Soup soupOf(const Triangles& triangles);

/// A quad mesh as OBJ.
[[nodiscard]] std::string writeObj(const QuadMesh& mesh);

} // namespace qm
