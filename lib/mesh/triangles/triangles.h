/// \file A surface of triangles, such as a scan.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

struct Triangles {
    std::vector<Point> points;
    std::vector<std::array<int, 3>> faces; ///< counter-clockwise seen from outside
};

} // namespace qm
