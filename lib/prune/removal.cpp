#include "prune/removal.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace qm {
namespace {
std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}
} // namespace

Removal::Removal(const QuadMesh& mesh, const Layout& layout)
    : mesh_(mesh), border_(mesh.n_edges(), false), segmentOf_(mesh.n_faces(), -1),
      parent_(layout.segments.size()) {
    for (const EdgeId edge : mesh.edges())
        border_[at(edge.idx())] = mesh.is_boundary(edge);
    for (const LayoutTrack& track : layout.tracks)
        setBorder(track.track, true);
    for (std::size_t s = 0; s < layout.segments.size(); ++s)
        for (const FaceId face : layout.segments[s].faces)
            segmentOf_[at(face.idx())] = static_cast<int>(s);
    std::iota(parent_.begin(), parent_.end(), 0);
}

bool Removal::isBorder(HalfedgeId halfedge) const {
    return border_[at(mesh_.edge_handle(halfedge).idx())];
}

void Removal::setBorder(const Track& track, bool border) {
    for (const HalfedgeId halfedge : track.halfedges)
        border_[at(mesh_.edge_handle(halfedge).idx())] = border;
}

int Removal::find(int segment) {
    while (parent_[at(segment)] != segment)
        segment = parent_[at(segment)] = parent_[at(parent_[at(segment)])];
    return segment;
}

bool Removal::hasBorder(VertexId vertex) const {
    return std::ranges::any_of(mesh_.voh_range(vertex), [this](HalfedgeId h) { return isBorder(h); });
}

/// At most two quads between one border and the next; without borders an ordinary inner vertex of a grid.
bool Removal::properAround(VertexId vertex) const {
    if (!hasBorder(vertex)) return mesh_.valence(vertex) == 4;
    for (const HalfedgeId start : mesh_.voh_range(vertex)) {
        if (!isBorder(start) || mesh_.is_boundary(start)) continue;
        int quads = 1;
        for (HalfedgeId next = mesh_.ccw_rotated_halfedge_handle(start); !isBorder(next);
             next = mesh_.ccw_rotated_halfedge_handle(next))
            ++quads;
        if (quads > 2) return false;
    }
    return true;
}

Removal::Pairs Removal::joinedPairs(const Track& track) {
    Pairs pairs;
    bool newPiece = true;
    for (const HalfedgeId halfedge : track.halfedges) {
        if (newPiece)
            pairs.push_back(
                {find(segmentOf_[at(mesh_.face_handle(halfedge).idx())]),
                 find(segmentOf_[at(mesh_.face_handle(mesh_.opposite_halfedge_handle(halfedge)).idx())])});
        newPiece = hasBorder(mesh_.to_vertex_handle(halfedge));
    }
    return pairs;
}

bool Removal::keepsGrids(const Track& track) {
    setBorder(track, false);
    bool proper = properAround(mesh_.from_vertex_handle(track.halfedges.front()));
    for (const HalfedgeId halfedge : track.halfedges)
        proper = proper && properAround(mesh_.to_vertex_handle(halfedge));
    std::map<int, int> joined; // segments that this removal would join, before it is certain
    const auto representative = [&](int segment) {
        for (auto up = joined.find(segment); up != joined.end(); up = joined.find(segment))
            segment = up->second;
        return segment;
    };
    if (proper)
        for (const auto& [left, right] : joinedPairs(track)) {
            const int a = representative(left), b = representative(right);
            proper = proper && a != b;
            if (a != b) joined[a] = b;
        }
    setBorder(track, true);
    return proper;
}

/// The turn of the border that goes on past the first vertex of a halfedge when that is no border any more.
double Removal::turnAt(HalfedgeId leaving) const {
    HalfedgeId left = leaving, right = leaving;
    int quads = 0;
    do {
        if (mesh_.is_boundary(left)) return 0;
        left = mesh_.ccw_rotated_halfedge_handle(left);
        ++quads;
    } while (!isBorder(left) && left != leaving);
    do {
        right = mesh_.cw_rotated_halfedge_handle(right);
        if (mesh_.is_boundary(right)) return 0;
        ++quads;
    } while (!isBorder(right) && right != leaving);
    if (quads != 2) return 0;
    const Point before =
        mesh_.point(mesh_.from_vertex_handle(left)) - mesh_.point(mesh_.to_vertex_handle(left));
    const Point after =
        mesh_.point(mesh_.to_vertex_handle(right)) - mesh_.point(mesh_.from_vertex_handle(right));
    return std::atan2((before % after).norm(), before | after) * 180 / std::numbers::pi;
}

double Removal::largestTurn(const Track& track) const {
    const HalfedgeId first = track.halfedges.front();
    const HalfedgeId last = mesh_.opposite_halfedge_handle(track.halfedges.back());
    if (mesh_.from_vertex_handle(first) == mesh_.from_vertex_handle(last)) return 0; // a loop has no ends
    return std::max(turnAt(first), turnAt(last));
}

void Removal::remove(const Track& track) {
    setBorder(track, false);
    for (const auto& [left, right] : joinedPairs(track))
        parent_[at(find(left))] = find(right);
}

} // namespace qm
