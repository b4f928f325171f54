#include "export/boundary/drop_unused.h"

#include "base/keep_marked.h"

namespace qm {

void dropUnused(Boundary& boundary) {
    std::vector<bool> isUsed(boundary.edges.size());
    forEachUse(boundary, [&](std::size_t, const EdgeUse& use) { isUsed[use.edge] = true; });
    const auto edgeNumbers = keepMarked(boundary.edges, isUsed);
    for (BoundaryFace& face : boundary.faces)
        for (auto& loop : face.loops)
            for (EdgeUse& use : loop)
                use.edge = edgeNumbers[use.edge];
    isUsed.assign(boundary.vertices.size(), false);
    for (const BoundaryEdge& edge : boundary.edges)
        isUsed[edge.ends[0]] = isUsed[edge.ends[1]] = true;
    const auto vertexNumbers = keepMarked(boundary.vertices, isUsed);
    for (BoundaryEdge& edge : boundary.edges)
        for (std::size_t& end : edge.ends)
            end = vertexNumbers[end];
}

} // namespace qm
