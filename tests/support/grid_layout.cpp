#include "support/grid_layout.h"

namespace qm::test {
namespace {

int vertexNumber(const Grid& grid, int i, int j) {
    return grid.wrapped ? j * grid.columns + i % grid.columns : j * (grid.columns + 1) + i;
}

/// Column and row of the grid for a place in a turned rectangle.
std::array<int, 2> unturned(const Rectangle& r, int i, int j, int extra) {
    const int width = r.i1 - r.i0 - extra;
    const int height = r.j1 - r.j0 - extra;
    switch (r.turned) {
    case 0:
        return {r.i0 + i, r.j0 + j};
    case 1:
        return {r.i0 + width - j, r.j0 + i};
    case 2:
        return {r.i0 + width - i, r.j0 + height - j};
    default:
        return {r.i0 + j, r.j0 + height - i};
    }
}

Segment makeSegment(const Grid& grid, const Rectangle& r) {
    Segment segment;
    segment.size = {r.i1 - r.i0, r.j1 - r.j0};
    if (r.turned % 2 == 1) std::swap(segment.size[0], segment.size[1]);
    const auto [a, b] = segment.size;
    const auto vertex = [&](int i, int j) {
        const auto [column, row] = unturned(r, i, j, 0);
        return VertexId(vertexNumber(grid, column, row));
    };
    for (int i = 0; i <= a; ++i) {
        segment.sides[0].push_back(vertex(i, 0));
        segment.sides[2].push_back(vertex(a - i, b));
    }
    for (int j = 0; j <= b; ++j) {
        segment.sides[1].push_back(vertex(a, j));
        segment.sides[3].push_back(vertex(0, b - j));
    }
    for (std::size_t k = 0; k < 4; ++k)
        segment.corners[k] = segment.sides[k].front();
    for (int j = 0; j < b; ++j)
        for (int i = 0; i < a; ++i) {
            const auto [column, row] = unturned(r, i, j, 1);
            segment.faces.emplace_back(row * grid.columns + column % grid.columns);
        }
    return segment;
}

} // namespace

QuadMesh makeMesh(const Grid& grid) {
    QuadMesh mesh;
    const int vertexColumns = grid.wrapped ? grid.columns : grid.columns + 1;
    for (int j = 0; j <= grid.rows; ++j)
        for (int i = 0; i < vertexColumns; ++i)
            mesh.add_vertex(grid.place(i, j));
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i)
            mesh.add_face({VertexId(vertexNumber(grid, i, j)), VertexId(vertexNumber(grid, i + 1, j)),
                           VertexId(vertexNumber(grid, i + 1, j + 1)),
                           VertexId(vertexNumber(grid, i, j + 1))});
    return mesh;
}

Layout makeLayout(const Grid& grid, const std::vector<Rectangle>& rectangles) {
    Layout layout;
    for (const Rectangle& rectangle : rectangles)
        layout.segments.push_back(makeSegment(grid, rectangle));
    return layout;
}

} // namespace qm::test
