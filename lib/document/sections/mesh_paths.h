/// \file Vertices and paths of a mesh in the form in which documents list them.
#pragma once

#include "document/json/json_place.h"
#include "mesh/quad_mesh.h"

#include <optional>
#include <span>
#include <vector>

namespace qm {

[[nodiscard]] VertexId vertexAt(const QuadMesh& mesh, const JsonPlace& place);
/// A vertex; nothing for null.
[[nodiscard]] std::optional<VertexId> vertexOrNullAt(const QuadMesh& mesh, const JsonPlace& place);

/// The halfedges along a list of at least two vertices.
/// \throw Error  with the pointer of the first vertex that is no neighbour of the one before it
[[nodiscard]] std::vector<HalfedgeId> pathAt(const QuadMesh& mesh, const JsonPlace& place);

/// \throw Error  with the pointer of the first vertex at which the path does not go straight on over an
/// interior regular vertex
void requireStraight(const QuadMesh& mesh, const std::vector<HalfedgeId>& path, const JsonPlace& place);

/// The numbers of vertices or faces.
template <class Handles> [[nodiscard]] Json numbersOf(const Handles& handles) {
    Json::array_t numbers;
    numbers.reserve(handles.size());
    for (const auto handle : handles)
        numbers.emplace_back(handle.idx());
    return numbers;
}
[[nodiscard]] Json numberOf(const std::optional<VertexId>& vertex);
/// The vertices along consecutive halfedges.
[[nodiscard]] Json pathNumbers(const QuadMesh& mesh, std::span<const HalfedgeId> path);

/// Whether two sums of costs agree to within rounding.
[[nodiscard]] bool sameCost(double a, double b);

/// A cost, if an entry gives one, must equal the sum over the edges; or be null, if there is none.
void verifyCost(const JsonPlace& entry, const std::optional<double>& cost);

/// The ids of a list's entries must differ.
void verifyDistinctIds(const JsonPlace& list);

/// The id of entry `index` must be its position, because others refer to it.
void verifyPositionId(const JsonPlace& entry, std::size_t index);

} // namespace qm
