#include "layout/region.h"

#include "base/at.h"
#include "base/positions.h"

#include <algorithm>

namespace qm {

std::size_t BorderLoop::corners() const {
    return countIn(quads, 1);
}

RegionFinder::RegionFinder(const QuadMesh& mesh, const Borders& borders)
    : mesh_(mesh), borders_(borders), seen_(mesh.n_faces(), false), walked_(mesh.n_halfedges(), false) {}

std::vector<FaceId> RegionFinder::flood(FaceId start) {
    std::vector<FaceId> faces{start};
    seen_[at(start)] = true;
    for (std::size_t next = 0; next < faces.size(); ++next)
        for (const HalfedgeId halfedge : mesh_.fh_range(faces[next])) {
            if (borders_.isBorder(halfedge)) continue;
            const FaceId neighbour = mesh_.opposite_face_handle(halfedge);
            if (seen_[at(neighbour)]) continue;
            seen_[at(neighbour)] = true;
            faces.push_back(neighbour);
        }
    std::sort(faces.begin(), faces.end());
    return faces;
}

BorderLoop RegionFinder::walkLoop(HalfedgeId start) {
    BorderLoop loop;
    HalfedgeId halfedge = start;
    do {
        walked_[at(halfedge)] = true;
        loop.halfedges.push_back(halfedge);
        int quads = 1;
        HalfedgeId next = mesh_.next_halfedge_handle(halfedge);
        for (; !borders_.isBorder(next); ++quads)
            next = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(next));
        loop.quads.push_back(quads);
        halfedge = next;
    } while (halfedge != start);
    return loop;
}

std::vector<Region> RegionFinder::find(const std::vector<FaceId>& faces) {
    std::vector<Region> regions;
    for (const FaceId start : faces) {
        if (seen_[at(start)]) continue;
        Region region{flood(start), {}};
        for (const FaceId face : region.faces)
            for (const HalfedgeId halfedge : mesh_.fh_range(face))
                if (borders_.isBorder(halfedge) && !walked_[at(halfedge)])
                    region.loops.push_back(walkLoop(halfedge));
        regions.push_back(std::move(region));
    }
    for (const Region& region : regions) {
        for (const FaceId face : region.faces)
            seen_[at(face)] = false;
        for (const BorderLoop& loop : region.loops)
            for (const HalfedgeId halfedge : loop.halfedges)
                walked_[at(halfedge)] = false;
    }
    return regions;
}

} // namespace qm
