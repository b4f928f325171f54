#include "export/boundary/boundary_parts.h"

#include "base/disjoint_sets.h"
#include "mesh/nesting.h"

#include <algorithm>

namespace qm {

std::vector<BoundaryBody> bodiesOf(const std::vector<BoundaryPart>& parts) {
    std::vector<BoundaryBody> bodies(parts.size());
    for (std::size_t k = 0; k < parts.size(); ++k)
        if (parts[k].cavityOf)
            bodies[*parts[k].cavityOf].cavities.push_back(&parts[k]);
        else
            bodies[k].outer = &parts[k];
    std::erase_if(bodies, [](const BoundaryBody& body) { return body.outer == nullptr; });
    return bodies;
}

std::vector<BoundaryPart> boundaryParts(const QuadMesh& mesh, const Layout& layout,
                                        const SharedEdges& shared) {
    DisjointSets sets(shared.ofPatch.size());
    for (const SharedEdge& edge : shared.edges)
        sets.join(edge.places.front().patch, edge.places.back().patch);
    const auto isOpen = [&](std::size_t face) {
        return std::ranges::any_of(shared.ofPatch[face], [&](const EdgeUse& use) {
            return shared.edges[use.edge].places.size() < 2;
        });
    };
    std::vector<BoundaryPart> parts;
    std::vector<std::vector<FaceId>> quads; // of the closed ones
    for (const std::vector<std::size_t>& faces : sets.members()) {
        const bool closed = std::ranges::none_of(faces, isOpen);
        parts.push_back({faces, closed});
        std::vector<FaceId>& ofPart = quads.emplace_back();
        if (!closed) continue;
        for (const std::size_t face : faces)
            ofPart.insert(ofPart.end(), layout.segments[face].faces.begin(),
                          layout.segments[face].faces.end());
    }
    const std::vector<Nesting> nesting = nestingOf(mesh, quads);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        parts[k].inward = nesting[k].inward;
        parts[k].cavityOf = nesting[k].cavityOf;
    }
    return parts;
}

} // namespace qm
