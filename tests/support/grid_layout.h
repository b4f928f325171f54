/// \file Test meshes that are one grid, and layouts of them given as rectangles.
#pragma once

#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <functional>
#include <vector>

namespace qm::test {

/// A mesh of columns x rows quads. Vertex (i, j) lies at place(i, j) and has number j * (columns + 1) + i; if
/// the last column of vertices is the first one, j * columns + i.
struct Grid {
    int columns = 1;
    int rows = 1;
    std::function<Point(double, double)> place;
    bool wrapped = false;
};

[[nodiscard]] QuadMesh makeMesh(const Grid& grid);

/// The quads in columns [i0, i1) and rows [j0, j1) of a grid; `turned` is the number of quarter turns that
/// determine which of its sides is side 0.
struct Rectangle {
    int i0 = 0;
    int j0 = 0;
    int i1 = 1;
    int j1 = 1;
    int turned = 0;
};

[[nodiscard]] Layout makeLayout(const Grid& grid, const std::vector<Rectangle>& rectangles);

} // namespace qm::test
