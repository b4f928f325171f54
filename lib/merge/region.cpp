#include "merge/region.h"

#include <algorithm>
#include <unordered_set>

namespace qm {
namespace {

/// Walks the border that a halfedge is part of.
BorderLoop walkLoop(const QuadMesh& mesh, const Borders& borders, HalfedgeId start) {
    BorderLoop loop;
    HalfedgeId halfedge = start;
    do {
        loop.halfedges.push_back(halfedge);
        int quads = 1;
        HalfedgeId next = mesh.next_halfedge_handle(halfedge);
        for (; !borders.isBorder(next); ++quads)
            next = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(next));
        loop.quads.push_back(quads);
        halfedge = next;
    } while (halfedge != start);
    return loop;
}

std::vector<BorderLoop> findLoops(const QuadMesh& mesh, const Borders& borders,
                                  const std::vector<FaceId>& faces) {
    std::vector<BorderLoop> loops;
    std::unordered_set<int> walked;
    for (const FaceId face : faces)
        for (const HalfedgeId halfedge : mesh.fh_range(face)) {
            if (!borders.isBorder(halfedge) || walked.contains(halfedge.idx())) continue;
            loops.push_back(walkLoop(mesh, borders, halfedge));
            for (const HalfedgeId passed : loops.back().halfedges)
                walked.insert(passed.idx());
        }
    return loops;
}

} // namespace

std::size_t BorderLoop::corners() const {
    return static_cast<std::size_t>(std::ranges::count(quads, 1));
}

Borders::Borders(const QuadMesh& mesh) : border_(mesh.n_edges(), false) {
    for (const EdgeId edge : mesh.edges())
        if (mesh.is_boundary(edge)) add(edge);
}

std::vector<Region> findRegions(const QuadMesh& mesh, const Borders& borders,
                                const std::vector<FaceId>& faces) {
    std::vector<Region> regions;
    std::unordered_set<int> seen;
    seen.reserve(faces.size() * 2);
    for (const FaceId start : faces) {
        if (!seen.insert(start.idx()).second) continue;
        Region region{{start}, {}};
        for (std::size_t next = 0; next < region.faces.size(); ++next)
            for (const HalfedgeId halfedge : mesh.fh_range(region.faces[next])) {
                if (borders.isBorder(halfedge)) continue;
                const FaceId neighbour = mesh.face_handle(mesh.opposite_halfedge_handle(halfedge));
                if (seen.insert(neighbour.idx()).second) region.faces.push_back(neighbour);
            }
        std::sort(region.faces.begin(), region.faces.end());
        region.loops = findLoops(mesh, borders, region.faces);
        regions.push_back(std::move(region));
    }
    return regions;
}

} // namespace qm
