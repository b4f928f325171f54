/// \file Tracks and edges given by vertex numbers, and numbers of handles.
#pragma once

#include "layout/motorcycle_graph.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm::test {

using Path = std::vector<int>;

/// \param path  vertices, each joined to the next by an edge
[[nodiscard]] Track trackAlong(const QuadMesh& mesh, const Path& path, double cost = 0);

/// A value for every edge of the mesh: `rest`, except on the edges along some paths.
class PerEdge {
public:
    PerEdge(const QuadMesh& mesh, double rest) : mesh_(mesh), values_(mesh.n_edges(), rest) {}

    PerEdge& along(const Path& path, double value);
    operator const std::vector<double>&() const { return values_; } // NOLINT: implicit on purpose

private:
    const QuadMesh& mesh_;
    std::vector<double> values_;
};

template <class Handles> [[nodiscard]] Path numbers(const Handles& handles) {
    Path result;
    for (const auto handle : handles)
        result.push_back(handle.idx());
    return result;
}

/// The vertices of a track.
[[nodiscard]] Path pathOf(const QuadMesh& mesh, const Track& track);

/// A mesh of columns x rows squares in the plane; vertex (i, j) has number j * (columns + 1) + i.
[[nodiscard]] QuadMesh rectangle(int columns, int rows);

} // namespace qm::test
