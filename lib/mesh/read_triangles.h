/// \file Reading a surface of triangles from the bytes of a file.
#pragma once

#include "mesh/triangles.h"

#include <string_view>

namespace qm {

/// STL, PLY, OBJ or OFF. Polygons of more corners become fans. Points with equal coordinates become one, so
/// that facets of an STL are neighbours; triangles that have one point twice, and points that no triangle
/// uses, are left out. Takes n log n time.
/// \param name  of the file; its extension tells the format, and where it has none the first word does
/// \throw Error  naming the place, if the file is not whole, holds no triangle or one without area only, or a
/// number that is none
[[nodiscard]] Triangles readTriangles(std::string_view bytes, std::string_view name);

} // namespace qm
