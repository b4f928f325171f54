#include "prune/prune.h"

#include "base/at.h"
#include "base/positions.h"
#include "prune/removal.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <utility>

namespace qm {
namespace {

enum class Fate { keep, notQuadrilateral, notSmooth, removed };

/// The candidates in decreasing order of cost; ties are in the order of ids.
std::vector<std::size_t> candidates(const QuadMesh& mesh, const Layout& layout, const PruneOptions& options) {
    std::vector<bool> isRequired(mesh.n_edges());
    for (const EdgeId edge : options.constraints.required)
        isRequired[at(edge)] = true;
    const auto mayGo = [&](const LayoutTrack& track) {
        return !track.transversal && track.track.cost > options.eta &&
               std::ranges::none_of(track.track.halfedges, [&](HalfedgeId halfedge) {
                   return isRequired[at(mesh.edge_handle(halfedge))];
               });
    };
    std::vector<std::size_t> order;
    for (std::size_t t = 0; t < layout.tracks.size(); ++t)
        if (mayGo(layout.tracks[t])) order.push_back(t);
    std::ranges::stable_sort(order, std::greater{},
                             [&](std::size_t t) { return layout.tracks[t].track.cost; });
    return order;
}

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// For every edge, the rank of the candidate that contains it, or `none`.
std::vector<std::size_t> rankOfEdges(const QuadMesh& mesh, const Layout& layout,
                                     const std::vector<std::size_t>& order) {
    std::vector<std::size_t> rankOf(mesh.n_edges(), none);
    for (std::size_t rank = 0; rank < order.size(); ++rank)
        for (const HalfedgeId halfedge : layout.tracks[order[rank]].track.halfedges)
            rankOf[at(mesh.edge_handle(halfedge))] = rank;
    return rankOf;
}

Fate judge(Removal& removal, const Track& track, const std::vector<double>& dihedralAngles,
           const PruneOptions& options) {
    if (!removal.keepsGrids(track)) return Fate::notQuadrilateral;
    if (options.smooth && (removal.largestTurn(track) > options.maxTurn ||
                           !removal.leavesRoom(track, dihedralAngles, options.minCorner)))
        return Fate::notSmooth;
    return Fate::removed;
}

/// Tries the candidates until none can be removed. A candidate that was kept is tried again only after a
/// track beside it has been removed, because the outcome would be the same before.
/// \return the fate of every track
std::vector<Fate> decide(const PrunedMesh& pruned, const Layout& layout, const PruneOptions& options,
                         const Control& control) {
    Removal removal(pruned.mesh, layout);
    const std::vector<std::size_t> order = candidates(pruned.mesh, layout, options),
                                   rankOf = rankOfEdges(pruned.mesh, layout, order);
    std::vector<Fate> fates(layout.tracks.size(), Fate::keep);
    std::set<std::size_t> pass, nextPass; // ranks
    for (std::size_t rank = 0; rank < order.size(); ++rank)
        pass.insert(pass.end(), rank);
    while (!pass.empty() && !control.stopRequested()) {
        const std::size_t rank = *pass.begin();
        pass.erase(pass.begin());
        const Track& track = layout.tracks[order[rank]].track;
        Fate& fate = fates[order[rank]];
        fate = judge(removal, track, pruned.dihedralAngles, options);
        if (fate == Fate::removed)
            for (const EdgeId edge : removal.remove(track)) {
                const std::size_t other = rankOf[at(edge)];
                if (other != none) (other > rank ? pass : nextPass).insert(other);
            }
        if (pass.empty()) std::swap(pass, nextPass);
    }
    return fates;
}

bool dominates(const FrontPoint& one, const FrontPoint& other) {
    constexpr double rounding = 1e-9;
    return one.segments <= other.segments && one.cost <= other.cost + rounding &&
           one.capturedSharpness >= other.capturedSharpness - rounding;
}

} // namespace

PruneResult pruneLayout(const PrunedMesh& pruned, const Layout& layout, const PruneOptions& options,
                        const Control& control) {
    const std::vector<Fate> fates = decide(pruned, layout, options, control);
    std::vector<Track> kept;
    for (std::size_t t = 0; t < layout.tracks.size(); ++t)
        if (!layout.tracks[t].transversal && fates[t] != Fate::removed)
            kept.push_back(layout.tracks[t].track);
    PruneResult result;
    result.layout = buildLayout(pruned.mesh, kept, pruned.dihedralAngles, pruned.edgeCosts);
    const auto number = [&](Fate fate) { return countIn(fates, fate); };
    result.removedTracks = number(Fate::removed);
    result.keptNotQuadrilateral = number(Fate::notQuadrilateral);
    result.keptNotSmooth = number(Fate::notSmooth);
    return result;
}

void addToFront(std::vector<FrontPoint>& front, const FrontPoint& point) {
    if (std::ranges::any_of(front, [&](const FrontPoint& other) { return dominates(other, point); })) return;
    std::erase_if(front, [&](const FrontPoint& other) { return dominates(point, other); });
    front.push_back(point);
}

} // namespace qm
