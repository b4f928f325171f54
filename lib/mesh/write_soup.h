/// \file Writing polygons as the formats that can be read.
#pragma once

#include "mesh/mesh_format.h"
#include "mesh/soup.h"
#include "mesh/triangles.h"

#include <string>

namespace qm {

/// OBJ and OFF are text in which coordinates have the fewest digits that read back exactly, PLY is binary
/// with double precision, STL is binary with single precision.
/// \param soup  its indices are in range; for STL all polygons are triangles
[[nodiscard]] std::string writeSoup(const Soup& soup, MeshFormat format);

/// With the mesh's numbering, faces with their first vertex first.
[[nodiscard]] Soup soupOf(const QuadMesh& mesh);
[[nodiscard]] Soup soupOf(const Triangles& triangles);

/// A quad mesh as OBJ.
[[nodiscard]] std::string writeObj(const QuadMesh& mesh);

} // namespace qm
