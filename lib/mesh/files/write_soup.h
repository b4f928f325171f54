/// \file Writing polygons in the formats that can be read.
#pragma once

#include "mesh/files/mesh_format.h"
#include "mesh/soup/soup.h"
#include "mesh/triangles/triangles.h"

#include <string>

namespace qm {

/// OBJ and OFF are text whose coordinates have the fewest digits that read back exactly; PLY is binary with
/// double precision; STL is binary with single precision.
/// \param soup  indices must be in range; for STL all polygons must be triangles
[[nodiscard]] std::string writeSoup(const Soup& soup, MeshFormat format);

/// The faces of a mesh with its numbering; each begins with its first vertex.
[[nodiscard]] Soup soupOf(const QuadMesh& mesh);
[[nodiscard]] Soup soupOf(const Triangles& triangles);

/// A quad mesh as OBJ.
[[nodiscard]] std::string writeObj(const QuadMesh& mesh);

} // namespace qm
