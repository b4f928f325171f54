// A box with rounded edges and corners.
#pragma once

#include "base/at.h"
#include "mesh/quad_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace qm::test {

/// A box of 60 x 40 x 20 with round edges and corners: few narrow quads beside many wide ones, or beside few
/// that are wider still.
class RoundedBox {
public:
    /// \param fillet  number of quads around an edge, even
    /// \param flat    number of quads along the flat part of every side
    /// \param radius  of edges and corners
    RoundedBox(int fillet, int flat, double radius = 4) : half_(fillet / 2), flat_(flat), radius_(radius) {
        for (int axis = 0; axis < 3; ++axis)
            for (const int level : {0, steps()})
                for (int i = 0; i < steps(); ++i)
                    for (int j = 0; j < steps(); ++j)
                        addQuad(axis, level, i, j);
    }

    [[nodiscard]] const QuadMesh& mesh() const { return mesh_; }

private:
    using Index = std::array<int, 3>; ///< on the surface of a cube

    [[nodiscard]] int steps() const { return 2 * half_ + flat_; }

    void addQuad(int axis, int level, int i, int j) {
        std::array<VertexId, 4> corners;
        int corner = 0;
        for (const auto& [di, dj] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
            Index index{};
            index[at(axis)] = level;
            index[at((axis + 1) % 3)] = i + di;
            index[at((axis + 2) % 3)] = j + dj;
            corners[at(corner++)] = vertex(index);
        }
        if (level == 0) std::swap(corners[1], corners[3]);
        mesh_.add_face(corners[0], corners[1], corners[2], corners[3]);
    }

    VertexId vertex(const Index& index) {
        const auto found = vertices_.find(index);
        if (found != vertices_.end()) return found->second;
        return vertices_[index] = mesh_.add_vertex(place(index));
    }

    [[nodiscard]] Point place(const Index& index) const {
        const Point half(30 - radius_, 20 - radius_, 10 - radius_);
        Point core;
        Point direction;
        for (int axis = 0; axis < 3; ++axis) {
            const int from = std::clamp(index[at(axis)] - half_, 0, flat_); // the beginning of the flat part
            const int beyond = index[at(axis)] - half_ - from;
            core[at(axis)] = half[at(axis)] * (2.0 * from / flat_ - 1);
            direction[at(axis)] = std::tan(std::numbers::pi / 4 * beyond / half_);
        }
        return core + radius_ * direction.normalized();
    }

    int half_;
    int flat_;
    double radius_;
    QuadMesh mesh_;
    std::map<Index, VertexId> vertices_;
};

} // namespace qm::test
