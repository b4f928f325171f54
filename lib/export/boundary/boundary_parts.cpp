#include "export/boundary/boundary_parts.h"

#include "base/disjoint_sets.h"
#include "mesh/nesting.h"

namespace qm {
namespace {

/// By patch: its connected component, numbered in the order of the patches.
std::vector<std::size_t> patchComponents(const SharedEdges& shared) {
    DisjointSets sets(shared.ofPatch.size());
    for (const SharedEdge& edge : shared.edges)
        sets.join(edge.places.front().patch, edge.places.back().patch);
    std::vector<std::size_t> component(shared.ofPatch.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < component.size(); ++k) { // the lowest patch of a set comes first
        const std::size_t lowest = sets.find(k);
        component[k] = lowest == k ? count++ : component[lowest];
    }
    return component;
}

} // namespace

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
    const std::vector<std::size_t> component = patchComponents(shared);
    std::vector<BoundaryPart> parts;
    for (std::size_t k = 0; k < component.size(); ++k) {
        if (component[k] == parts.size()) parts.push_back({{}, true, false});
        parts[component[k]].faces.push_back(k);
    }
    for (const SharedEdge& edge : shared.edges)
        if (edge.places.size() < 2) parts[component[edge.places.front().patch]].closed = false;
    std::vector<std::vector<FaceId>> quads(parts.size()); // of the closed ones
    for (std::size_t k = 0; k < component.size(); ++k) {
        const std::vector<FaceId>& ofFace = layout.segments[k].faces;
        std::vector<FaceId>& ofPart = quads[component[k]];
        if (parts[component[k]].closed) ofPart.insert(ofPart.end(), ofFace.begin(), ofFace.end());
    }
    const std::vector<Nesting> nesting = nestingOf(mesh, quads);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        parts[k].inward = nesting[k].inward;
        parts[k].cavityOf = nesting[k].cavityOf;
    }
    return parts;
}

} // namespace qm
