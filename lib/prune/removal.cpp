#include "prune/removal.h"

#include "base/at.h"
#include "base/positions.h"
#include "base/sparse_disjoint_sets.h"
#include "mesh/topology.h"
#include "prune/border_angles.h"
#include "prune/vertex_room.h"

#include <algorithm>

namespace qm {

Removal::Removal(const QuadMesh& mesh, const Layout& layout)
    : mesh_(mesh), borders_(mesh, properTracks(layout)), segmentOf_(segmentsOfFaces(mesh, layout)),
      sets_(layout.segments.size()) {}

SegmentId Removal::find(SegmentId segment) {
    return SegmentId(sets_.find(segment.idx()));
}

Removal::Sector Removal::sectorAt(HalfedgeId leaving) const {
    Sector sector{leaving, leaving, 0};
    do {
        sector.left = mesh_.ccw_rotated_halfedge_handle(sector.left);
        ++sector.quads;
    } while (!borders_.isBorder(sector.left) && sector.left != leaving);
    do {
        sector.right = mesh_.cw_rotated_halfedge_handle(sector.right);
        ++sector.quads;
    } while (!borders_.isBorder(sector.right) && sector.right != leaving);
    return sector;
}

/// Whether a segment has a straight or convex border here, or an ordinary vertex inside.
bool Removal::properAt(HalfedgeId leaving) const {
    const Sector sector = sectorAt(leaving);
    return sector.quads <= 2 || (sector.quads == 8 && !borders_.isBorder(sector.left));
}

bool Removal::properAlong(const Track& track) const {
    return std::ranges::all_of(track.halfedges, [this](HalfedgeId h) {
        return properAt(h) && properAt(mesh_.opposite_halfedge_handle(h));
    });
}

Removal::Pairs Removal::joinedPairs(const Track& track) {
    const VertexId first = mesh_.from_vertex_handle(track.halfedges.front()),
                   last = mesh_.to_vertex_handle(track.halfedges.back());
    Pairs pairs;
    bool newPiece = first != last || borders_.hasBorder(first); // otherwise the last piece continues here
    for (const HalfedgeId halfedge : track.halfedges) {
        if (newPiece)
            pairs.push_back({find(segmentOf_[at(mesh_.face_handle(halfedge))]),
                             find(segmentOf_[at(mesh_.opposite_face_handle(halfedge))])});
        newPiece = borders_.hasBorder(mesh_.to_vertex_handle(halfedge));
    }
    return pairs;
}

bool Removal::joinsForest(const Track& track) {
    SparseDisjointSets joined; // segments joined by this removal, which may not happen
    const Pairs pairs = joinedPairs(track);
    if (pairs.empty()) return false; // a loop with annuli on both sides
    return std::ranges::all_of(pairs, [&](const std::array<SegmentId, 2>& pair) {
        return joined.join(pair[0].value(), pair[1].value());
    });
}

bool Removal::keepsGrids(const Track& track) {
    borders_.remove(track.halfedges);
    const bool keeps = properAlong(track) && joinsForest(track);
    borders_.add(track.halfedges);
    return keeps;
}

double Removal::turnAt(HalfedgeId leaving) const {
    const Sector sector = sectorAt(leaving);
    return turnBetween(mesh_, sector.left, sector.right);
}

double Removal::largestTurn(const Track& track) const {
    return std::max(turnAt(track.halfedges.front()),
                    turnAt(mesh_.opposite_halfedge_handle(track.halfedges.back())));
}

bool Removal::leavesRoom(const Track& track, const std::vector<double>& dihedralAngles,
                         double minCorner) const {
    const std::array ends{track.halfedges.front(), mesh_.opposite_halfedge_handle(track.halfedges.back())};
    const auto isRemoved = [&](HalfedgeId leaving) { return leaving == ends[0] || leaving == ends[1]; };
    const auto isMissing = [&](HalfedgeId leaving) {
        return isRemoved(leaving) || !borders_.isBorder(leaving);
    };
    const auto hasRoom = [&](const RoomSector& sector) {
        return std::ranges::none_of(sector.edges, isRemoved) ||
               countWhere(sector.edges, isMissing) <= sector.maxMissing;
    };
    return std::ranges::all_of(ends, [&](HalfedgeId end) {
        const VertexId vertex = mesh_.from_vertex_handle(end);
        return isRegular(mesh_, vertex) ||
               std::ranges::all_of(roomAt(mesh_, dihedralAngles, vertex, minCorner), hasRoom);
    });
}

std::vector<EdgeId> Removal::remove(const Track& track) {
    borders_.remove(track.halfedges);
    for (const auto& [left, right] : joinedPairs(track))
        sets_.join(left.idx(), right.idx());
    std::vector<EdgeId> beside;
    for (const HalfedgeId halfedge : track.halfedges)
        for (const HalfedgeId leaving : {halfedge, mesh_.opposite_halfedge_handle(halfedge)}) {
            const Sector sector = sectorAt(leaving);
            for (const HalfedgeId next : {sector.left, sector.right})
                if (borders_.isBorder(next)) beside.push_back(mesh_.edge_handle(next));
        }
    return beside;
}

} // namespace qm
