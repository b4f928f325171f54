#include "bench/sample_models.h"

#include "base/at.h"
#include "support/polycube.h"
#include "support/random_graph.h"

#include <algorithm>
#include <array>
#include <vector>

namespace qm::bench {
namespace {

constexpr int width = 3;  ///< of a bar, in cells
constexpr int height = 2; ///< of a bar, in cells
constexpr std::array hole{2, 1};
constexpr int twist = 2; ///< of one bar: vertices by which the cut ends are shifted

test::Cells ring() {
    test::Cells cells;
    for (const auto& cell : test::box(hole[0] + 2 * width, hole[1] + 2 * width, height))
        if (cell[0] < width || cell[0] >= width + hole[0] || cell[1] < width || cell[1] >= width + hole[1])
            cells.push_back(cell);
    return cells;
}

/// The vertices around the bar at its beginning, in order.
std::vector<int> section(const check::CheckedMesh& mesh) {
    std::vector<std::array<double, 3>> places;
    places.reserve(2 * at(width + height));
    const double x = width, far = width, top = height;
    for (int y = 0; y < width; ++y)
        places.push_back({x, static_cast<double>(y), 0});
    for (int z = 0; z < height; ++z)
        places.push_back({x, far, static_cast<double>(z)});
    for (int y = width; y > 0; --y)
        places.push_back({x, static_cast<double>(y), top});
    for (int z = height; z > 0; --z)
        places.push_back({x, 0, static_cast<double>(z)});
    std::vector<int> vertices;
    vertices.reserve(places.size());
    for (const auto& place : places)
        vertices.push_back(static_cast<int>(std::ranges::find(mesh.points, place) - mesh.points.begin()));
    return vertices;
}

/// Whether a quad lies between the section and the next one.
bool isBehindSection(const check::CheckedMesh& mesh, const std::array<int, 4>& quad) {
    return std::ranges::all_of(quad, [&](int vertex) {
        const auto& point = mesh.points[at(vertex)];
        return point[0] >= width && point[0] <= width + 1 && point[1] <= width;
    });
}

} // namespace

QuadMesh studs(int count) {
    test::Cells cells = test::box(2 * count + 1, 3, 1);
    for (int k = 0; k < count; ++k)
        cells.push_back({2 * k + 1, 1, 1});
    return test::quadMesh(test::polycube(cells, 2));
}

QuadMesh paperTorus() {
    check::CheckedMesh mesh = test::polycube(ring());
    const std::vector<int> around = section(mesh);
    for (auto& quad : mesh.quads) {
        if (!isBehindSection(mesh, quad)) continue;
        for (int& vertex : quad)
            if (const auto place = std::ranges::find(around, vertex); place != around.end())
                vertex = around[at(place - around.begin() + twist) % around.size()];
    }
    return test::quadMesh(mesh);
}

} // namespace qm::bench
