#include "prune/added_tracks.h"

#include "base/at.h"
#include "layout/tracks.h"
#include "mesh/topology.h"

#include <algorithm>

namespace qm {

AddedTracks::AddedTracks(const PrunedMesh& pruned, const Layout& layout, const std::vector<EdgeId>& forbidden)
    : pruned_(pruned), earlier_(properTracks(layout)), borders_(pruned.mesh, earlier_),
      isForbidden_(pruned.mesh.n_edges()) {
    for (const EdgeId edge : forbidden)
        isForbidden_[at(edge)] = true;
}

std::vector<HalfedgeId> AddedTracks::pathFrom(HalfedgeId first) const {
    std::vector<HalfedgeId> path{first};
    while (!borders_.hasBorder(pruned_.mesh.to_vertex_handle(path.back()))) {
        const HalfedgeId next = straightOn(pruned_.mesh, path.back());
        if (next == first) break;
        path.push_back(next);
    }
    return path;
}

bool AddedTracks::add(const std::vector<HalfedgeId>& path) {
    if (std::ranges::any_of(
            path, [&](HalfedgeId step) { return isForbidden_[at(pruned_.mesh.edge_handle(step))]; }))
        return false;
    borders_.add(path);
    added_.push_back(trackOf(pruned_.mesh, path, pruned_.edgeCosts));
    return true;
}

std::optional<HalfedgeId> AddedTracks::addFrom(HalfedgeId first) {
    const std::vector<HalfedgeId> path = pathFrom(first);
    return add(path) ? std::optional(path.back()) : std::nullopt;
}

void AddedTracks::addThrough(HalfedgeId inside) {
    const HalfedgeId back = pruned_.mesh.opposite_halfedge_handle(inside);
    add(pathFrom(pruned_.mesh.opposite_halfedge_handle(pathFrom(back).back())));
}

Layout AddedTracks::layout() const {
    std::vector<Track> tracks = earlier_;
    tracks.insert(tracks.end(), added_.begin(), added_.end());
    return buildLayout(pruned_.mesh, tracks, pruned_.dihedralAngles, pruned_.edgeCosts);
}

} // namespace qm
