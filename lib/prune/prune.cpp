#include "prune/prune.h"

#include "prune/removal.h"

#include <algorithm>

namespace qm {
namespace {

enum class Fate { keep, notQuadrilateral, notSmooth, removed };

/// Candidates in decreasing order of cost, ties by id.
std::vector<std::size_t> candidates(const Layout& layout, double eta) {
    std::vector<std::size_t> order;
    for (std::size_t t = 0; t < layout.tracks.size(); ++t)
        if (!layout.tracks[t].transversal && layout.tracks[t].track.cost > eta) order.push_back(t);
    std::ranges::stable_sort(order, std::greater{},
                             [&](std::size_t t) { return layout.tracks[t].track.cost; });
    return order;
}

} // namespace

PruneResult pruneLayout(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                        const std::vector<double>& edgeCosts, const PruneOptions& options,
                        const Control& control) {
    Removal removal(mesh, layout);
    const std::vector<std::size_t> order = candidates(layout, options.eta);
    std::vector<Fate> fates(layout.tracks.size(), Fate::keep);
    // A removal can free a track that was tried before it: go through them until none goes.
    for (bool changed = true; changed && !control.stopRequested();) {
        changed = false;
        for (const std::size_t t : order) {
            if (fates[t] == Fate::removed) continue;
            const Track& track = layout.tracks[t].track;
            if (!removal.keepsGrids(track)) {
                fates[t] = Fate::notQuadrilateral;
            } else if (options.smooth && removal.largestTurn(track) > options.maxTurn) {
                fates[t] = Fate::notSmooth;
            } else {
                removal.remove(track);
                fates[t] = Fate::removed;
                changed = true;
            }
        }
    }
    std::vector<Track> kept;
    for (std::size_t t = 0; t < layout.tracks.size(); ++t)
        if (!layout.tracks[t].transversal && fates[t] != Fate::removed)
            kept.push_back(layout.tracks[t].track);
    PruneResult result;
    result.layout = buildLayout(mesh, kept, dihedralAngles, edgeCosts);
    const auto number = [&](Fate fate) { return static_cast<std::size_t>(std::ranges::count(fates, fate)); };
    result.removedTracks = number(Fate::removed);
    result.keptNotQuadrilateral = number(Fate::notQuadrilateral);
    result.keptNotSmooth = number(Fate::notSmooth);
    return result;
}

} // namespace qm
