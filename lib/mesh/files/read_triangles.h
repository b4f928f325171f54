/// \file Reading a surface of triangles from the bytes of a file.
#pragma once

#include "mesh/triangles/triangles.h"

#include <string_view>

namespace qm {

/// Reads STL, PLY, OBJ or OFF. Polygons with more corners are divided into fans. Points with equal
/// coordinates are merged, so that facets of an STL file are neighbours; triangles that use a point twice,
/// and unused points, are dropped. Takes n log n time.
/// \param name  of the file; its extension determines the format, or, if there is none, the first word
/// \throw Error  with the place, if the file is truncated, contains an invalid number, or has no triangle
/// with an area
[[nodiscard]] Triangles readTriangles(std::string_view bytes, std::string_view name);

} // namespace qm
