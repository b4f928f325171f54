/// \file Building a mesh from lists of points and quads.
#pragma once

#include "mesh/soup/soup.h"

#include <array>
#include <vector>

namespace qm {

/// \throw Error  as `validateSoup`
[[nodiscard]] QuadMesh buildMesh(const Soup& soup);

/// The same for plain lists.
[[nodiscard]] QuadMesh buildMesh(const std::vector<Point>& points,
                                 const std::vector<std::array<int, 4>>& quads);

} // namespace qm
