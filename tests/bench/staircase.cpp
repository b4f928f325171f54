#include "bench/staircase.h"

#include "base/at.h"

#include <array>
#include <cmath>
#include <map>

namespace qm::bench {
namespace {

using Lattice = std::array<int, 3>;

/// Whether the unit cell (x, y, z) lies below a sloping plane.
bool isSolid(int steps, const Lattice& cell) {
    const auto [x, y, z] = cell;
    return x >= 0 && y >= 0 && z >= 0 && x + y + z < steps;
}

class Surface {
public:
    explicit Surface(int refinement) : refinement_(refinement) {}

    /// Adds a square given by its lowest corner and two axes; `flipped` reverses its orientation.
    void addSquare(const Lattice& corner, int axisU, int axisV, bool flipped) {
        for (int j = 0; j < refinement_; ++j)
            for (int i = 0; i < refinement_; ++i) {
                const VertexId a = vertex(corner, axisU, i, axisV, j);
                const VertexId b = vertex(corner, axisU, i + 1, axisV, j);
                const VertexId c = vertex(corner, axisU, i + 1, axisV, j + 1);
                const VertexId d = vertex(corner, axisU, i, axisV, j + 1);
                if (flipped)
                    mesh_.add_face(a, d, c, b);
                else
                    mesh_.add_face(a, b, c, d);
            }
    }

    [[nodiscard]] QuadMesh take() { return std::move(mesh_); }

private:
    VertexId vertex(const Lattice& corner, int axisU, int i, int axisV, int j) {
        Lattice position;
        for (std::size_t axis = 0; axis < 3; ++axis)
            position[axis] = corner[axis] * refinement_;
        position[at(axisU)] += i;
        position[at(axisV)] += j;
        const auto [place, isNew] = vertices_.try_emplace(position);
        if (isNew) place->second = mesh_.add_vertex(bend(position));
        return place->second;
    }

    [[nodiscard]] Point bend(const Lattice& position) const {
        const Point p = Point(position[0], position[1], position[2]) / refinement_;
        return p +
               0.1 * Point(std::sin(p[1] + 2 * p[2]), std::sin(p[2] + 2 * p[0]), std::sin(p[0] + 2 * p[1]));
    }

    int refinement_;
    QuadMesh mesh_;
    std::map<Lattice, VertexId> vertices_;
};

} // namespace

QuadMesh staircase(int steps, int refinement) {
    Surface surface(refinement);
    for (int z = 0; z < steps; ++z)
        for (int y = 0; y < steps; ++y)
            for (int x = 0; x < steps; ++x) {
                const Lattice cell{x, y, z};
                if (!isSolid(steps, cell)) continue;
                for (int axis = 0; axis < 3; ++axis)
                    for (const int side : {0, 1}) {
                        Lattice neighbour = cell;
                        neighbour[at(axis)] += side == 1 ? 1 : -1;
                        if (isSolid(steps, neighbour)) continue;
                        Lattice corner = cell;
                        corner[at(axis)] += side;
                        surface.addSquare(corner, (axis + 1) % 3, (axis + 2) % 3, side == 0);
                    }
            }
    return surface.take();
}

} // namespace qm::bench
