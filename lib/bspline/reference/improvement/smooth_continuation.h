/// \file Where the smoothest continuation of their surroundings has some vertices of a mesh
/// (docs/METHOD.md#reference).
#pragma once

#include "mesh/quad_mesh.h"

#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

namespace qm {

/// Vertices that are to move.
class MovingVertices {
public:
    [[nodiscard]] const std::vector<VertexId>& all() const { return vertices_; }
    [[nodiscard]] bool contains(VertexId vertex) const { return numbers_.contains(vertex); }
    /// Its place in the order of addition; nothing if it does not move.
    [[nodiscard]] std::optional<int> number(VertexId vertex) const {
        const auto found = numbers_.find(vertex);
        return found != numbers_.end() ? std::optional(found->second) : std::nullopt;
    }

    void add(VertexId vertex) {
        if (numbers_.emplace(vertex, static_cast<int>(vertices_.size())).second) vertices_.push_back(vertex);
    }

private:
    std::vector<VertexId> vertices_;
    std::unordered_map<VertexId, int> numbers_;
};

/// Whether a vertex belongs to so many quads that it lies where they have it: it is to stay, and its
/// difference does not count, lest equations become quadratic in their number.
[[nodiscard]] bool isHub(const QuadMesh& mesh, VertexId vertex);

/// Least squares of the differences between vertices and the mean of their neighbours, for those that move
/// and those beside them: a thin plate through what stays.
/// \param counts  whether the difference of a vertex beside those that move counts
/// \return by moving vertex; nothing if a whole component moves, so that nothing says where
[[nodiscard]] std::optional<std::vector<Point>>
smoothContinuation(const QuadMesh& mesh, const MovingVertices& moving,
                   const std::function<bool(VertexId)>& counts, unsigned jobs);

/// The places of vertices.
[[nodiscard]] std::vector<Point> pointsOf(const QuadMesh& mesh, const std::vector<VertexId>& vertices);

/// Moves as many of the vertices as there are places.
void setPoints(QuadMesh& mesh, const std::vector<VertexId>& vertices, const std::vector<Point>& points);

} // namespace qm
