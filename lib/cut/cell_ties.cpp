#include "cut/cell_ties.h"

#include "base/at.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace qm {
namespace {

/// The tie of a quad whose lowest corner in the sub-mesh is the one that the halfedge leaves.
std::optional<CellTie> tieOf(const QuadMesh& mesh, const std::vector<SubMeshId>& labels, HalfedgeId halfedge,
                             const std::vector<int>& cellOf) {
    const VertexId vertex = mesh.from_vertex_handle(halfedge);
    CellTie tie{cellOf[at(vertex)]};
    std::size_t count = 1;
    for (int k = 1; k < 4; ++k) {
        const VertexId corner = mesh.to_vertex_handle(halfedge);
        halfedge = mesh.next_halfedge_handle(halfedge);
        if (labels[at(corner)] != labels[at(vertex)]) continue;
        if (corner.idx() < vertex.idx()) return std::nullopt;
        const int cell = cellOf[at(corner)];
        if (std::find(tie.begin(), tie.begin() + count, cell) == tie.begin() + count) tie[count++] = cell;
    }
    if (count < 2) return std::nullopt;
    std::rotate(tie.begin(), std::min_element(tie.begin(), tie.begin() + count), tie.begin() + count);
    std::fill(tie.begin() + count, tie.end(), tie[count - 1]);
    return tie;
}

} // namespace

std::vector<CellTie> cellTies(const QuadMesh& mesh, const std::vector<SubMeshId>& labels,
                              const std::vector<VertexId>& vertices, const std::vector<int>& cellOf) {
    std::vector<CellTie> ties;
    for (const VertexId vertex : vertices)
        for (const HalfedgeId halfedge : mesh.voh_range(vertex))
            if (!mesh.is_boundary(halfedge))
                if (const auto tie = tieOf(mesh, labels, halfedge, cellOf)) ties.push_back(*tie);
    sortUnique(ties);
    return ties;
}

} // namespace qm
