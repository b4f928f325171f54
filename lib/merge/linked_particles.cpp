#include "merge/linked_particles.h"

#include "base/id_vector.h"
#include "enumerate/sub_mesh/line_walk.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

namespace qm {
namespace {

/// Collects the arcs inside a sub-mesh that may change.
class Closure {
public:
    Closure(const SearchSpace& space, const PresentArcs& present, SubMeshId subMesh)
        : space_(space), present_(present), subMesh_(subMesh) {}

    /// Adds the way of a free particle from its crash point up to the arc that leaves the sub-mesh.
    void addFree(Particle particle) {
        const int walked = LineWalk(space_.graph, particle).covered(present_);
        for (const ArcId step : walkInside(space_, particle, subMesh_, walked)) {
            if (present_[step]) break; // the track of the opposite particle
            take(step);
        }
    }

    /// Follows the links of all arcs collected so far.
    /// \return whether anything was added
    bool addLinked() {
        std::vector<ArcId> found;
        for (std::size_t k = followed_; k < order_.size(); ++k)
            for (const ArcId crossing : crossingTracks(order_[k]))
                found.push_back(crossing);
        followed_ = order_.size();
        const std::size_t before = order_.size();
        for (const ArcId arc : found)
            addStretch(arc);
        return order_.size() > before;
    }

    [[nodiscard]] LinkedParticles result(std::size_t freeLines) const {
        LinkedParticles result;
        result.arcs = order_;
        std::ranges::sort(result.arcs);
        std::map<LineId, int> stops;
        for (const ArcId arc : order_)
            ++stops[space_.graph.arcs[arc].line];
        result.linked = stops.size() - std::min(stops.size(), freeLines);
        for (const auto& [line, count] : stops)
            result.quasiComplexity += std::log2(count + 1);
        return result;
    }

private:
    void take(ArcId arc) {
        if (taken_.insert(arc).second) order_.push_back(arc);
    }

    /// The present arcs that meet an arc at its two ends, of other lines and of its own.
    [[nodiscard]] std::vector<ArcId> crossingTracks(ArcId arc) const {
        std::vector<ArcId> result;
        const bool isFirst = arc == space_.graph.lineOf(arc).firstArc;
        for (const ArcId before : {arc, arc - 1}) {
            if (before != arc && isFirst) continue;
            const JunctionId id = space_.graph.junctionAfter[before];
            if (!id.valid() || space_.junctionLabels[id] != subMesh_) continue;
            for (const ArcId other : space_.graph.junctions[id].arcs)
                if (other.valid() && other != arc && present_[other]) result.push_back(other);
        }
        return result;
    }

    /// Adds the part of a line that lies inside the sub-mesh around one of its arcs.
    void addStretch(ArcId arc) {
        if (taken_.contains(arc)) return;
        const Line& line = space_.graph.lineOf(arc);
        ArcId first = arc, last = arc;
        while (first > line.firstArc && space_.arcBegins[first] == subMesh_)
            first = first - 1;
        while (last < line.lastArc() && space_.arcEnds[last] == subMesh_)
            last = last + 1;
        for (const ArcId each : IdRange(first, last + 1))
            if (!leavesPresent(each)) take(each);
    }

    /// Whether a track crosses the cut here. Such arcs stay, because this search cannot change the track
    /// outside.
    [[nodiscard]] bool leavesPresent(ArcId arc) const {
        return present_[arc] && space_.arcBegins[arc] != space_.arcEnds[arc];
    }

    const SearchSpace& space_;
    const PresentArcs& present_;
    SubMeshId subMesh_;
    std::unordered_set<ArcId> taken_;
    std::vector<ArcId> order_;
    std::size_t followed_ = 0;
};

} // namespace

LinkedParticles linkedParticles(const SearchSpace& space, const PresentArcs& present,
                                const std::vector<Particle>& particles, SubMeshId subMesh, Linking linking) {
    Closure closure(space, present, subMesh);
    for (const Particle particle : particles)
        closure.addFree(particle);
    if (linking == Linking::direct) closure.addLinked();
    if (linking == Linking::closed)
        while (closure.addLinked()) {
        }
    return closure.result(particles.size());
}

} // namespace qm
