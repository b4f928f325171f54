#include "export/boundary_parts.h"

#include "base/disjoint_sets.h"

namespace qm {
namespace {

/// Of the mesh's quads, times six: negative if they look inwards.
double signedVolume(const QuadMesh& mesh, const Segment& segment, const Point& origin) {
    double sum = 0;
    for (const FaceId face : segment.faces) {
        std::vector<Point> corners;
        for (const VertexId vertex : mesh.fv_range(face))
            corners.push_back(mesh.point(vertex) - origin);
        for (std::size_t k = 2; k < corners.size(); ++k)
            sum += corners[0] | (corners[k - 1] % corners[k]);
    }
    return sum;
}

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

std::vector<BoundaryPart> boundaryParts(const QuadMesh& mesh, const Layout& layout,
                                        const SharedEdges& shared) {
    const std::vector<std::size_t> component = patchComponents(shared);
    std::vector<BoundaryPart> parts;
    std::vector<double> volume;
    for (std::size_t k = 0; k < component.size(); ++k) {
        if (component[k] == parts.size()) {
            parts.push_back({{}, true, false});
            volume.push_back(0);
        }
        parts[component[k]].faces.push_back(k);
        volume[component[k]] += signedVolume(mesh, layout.segments[k], mesh.point(VertexId(0)));
    }
    for (const SharedEdge& edge : shared.edges)
        if (edge.places.size() < 2) parts[component[edge.places.front().patch]].closed = false;
    for (std::size_t k = 0; k < volume.size(); ++k)
        parts[k].inward = parts[k].closed && volume[k] < 0;
    return parts;
}

} // namespace qm
