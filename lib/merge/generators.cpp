#include "merge/generators.h"

#include "base/at.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/sort_unique.h"
#include "enumerate/optimum/optimum.h"
#include "enumerate/sub_mesh/line_walk.h"
#include "layout/tracks.h"
#include "merge/free_particles.h"
#include "merge/linked_particles.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>

namespace qm {
namespace {

/// The end of the search of a sub-mesh.
struct SubMeshChanges {
    std::optional<std::vector<ArcId>> arcs; ///< whose presence changes; nothing if no valid graph was found
    bool impossible = false;                ///< whether it is proven that there is none
};

class Generator {
public:
    Generator(const SearchedMesh& searched, const SearchSpace& space, const Enumeration& enumeration,
              const GeneratorLimits& limits, const Control& control)
        : mesh_(searched.mesh), subMeshes_(searched.subMeshes), space_(space), enumeration_(enumeration),
          limits_(limits), control_(control),
          arcOfEdge_(arcsOfEdges(searched.mesh, space.graph, searched.complex)),
          present_(space.graph.arcs.size(), false), free_(space, present_) {}

    /// PMG: sub-meshes that no arc joins are searched at the same time, all others one after the other.
    void partial() {
        double done = 0;
        for (const auto& group : separateGroups()) {
            std::vector<std::vector<ArcId>> additions(group.size());
            parallelFor(group.size(), control_.jobs,
                        [&](std::size_t i) { additions[i] = searchPartial(group[i]); });
            for (const auto& arcs : additions)
                add(arcs);
            done += static_cast<double>(group.size());
            control_.progress(0.5 * done / subMeshes_.count);
        }
        result_.freeAfterPartial = free_.count();
    }

    /// CMG: rounds until no particle is free or a configuration repeats; then extends the remaining free
    /// particles straight on, the cheapest first.
    void complete() {
        while (static_cast<int>(result_.rounds) < limits_.rounds && !repeats() && free_.count() > 0 &&
               !control_.stopRequested()) {
            ++result_.rounds;
            rounds_.emplace_back();
            for (const SubMeshId subMesh : subMeshes_.ids())
                searchComplete(subMesh);
        }
        result_.searches = searches_;
        result_.extended = extendCheapestFirst(space_.graph, space_.arcCosts, present_);
    }

    /// Hands over the result; the generator must not be used afterwards.
    [[nodiscard]] GeneratedGraph take() { return {std::move(present_), std::move(result_)}; }

private:
    /// Groups of sub-meshes that no arc joins, by greedy colouring in the order of ids.
    [[nodiscard]] std::vector<std::vector<SubMeshId>> separateGroups() const {
        IdVector<SubMeshId, std::set<SubMeshId>> neighbours(at(subMeshes_.count));
        for (const ArcId arc : space_.arcBegins.ids()) {
            const SubMeshId a = space_.arcBegins[arc], b = space_.arcEnds[arc];
            if (a == b) continue;
            neighbours[a].insert(b);
            neighbours[b].insert(a);
        }
        IdVector<SubMeshId, int> groupOf(neighbours.size(), -1);
        std::vector<std::vector<SubMeshId>> groups;
        for (const SubMeshId subMesh : subMeshes_.ids()) {
            std::set<int> taken;
            for (const SubMeshId neighbour : neighbours[subMesh])
                taken.insert(groupOf[neighbour]);
            int group = 0;
            while (taken.contains(group))
                ++group;
            groupOf[subMesh] = group;
            if (group == static_cast<int>(groups.size())) groups.emplace_back();
            groups[at(group)].push_back(subMesh);
        }
        return groups;
    }

    void add(std::vector<ArcId> arcs) {
        std::erase_if(arcs, [&](ArcId arc) { return present_[arc]; });
        change(arcs);
    }

    /// Flips the presence of arcs, none of which is given twice.
    void change(const std::vector<ArcId>& arcs) {
        for (const ArcId arc : arcs)
            present_[arc].flip();
        free_.update(arcs);
        if (!rounds_.empty()) rounds_.back().insert(rounds_.back().end(), arcs.begin(), arcs.end());
    }

    /// Whether the present arcs are the same as before one of the rounds.
    [[nodiscard]] bool repeats() const {
        std::unordered_set<ArcId> differing;
        for (std::size_t round = rounds_.size(); round-- > 0;) {
            for (const ArcId arc : rounds_[round])
                if (!differing.insert(arc).second) differing.erase(arc);
            if (differing.empty()) return true;
        }
        return false;
    }

    /// The arcs that free particles may walk in a sub-mesh which they have entered.
    [[nodiscard]] std::vector<ArcId> enteringWalks(SubMeshId subMesh) const {
        std::vector<ArcId> arcs;
        for (const Particle particle : free_.in(subMesh)) {
            const int walked = LineWalk(space_.graph, particle).covered(present_);
            std::ranges::copy(walkInside(space_, particle, subMesh, walked), std::back_inserter(arcs));
        }
        return arcs;
    }

    /// PMG for one sub-mesh.
    /// \return the arcs to be added
    [[nodiscard]] std::vector<ArcId> searchPartial(SubMeshId subMesh) const {
        std::vector<ArcId> arcs = enteringWalks(subMesh);
        const auto& graphs = enumeration_.subMeshes[subMesh].graphs;
        if (arcs.empty() && !graphs.empty())
            return coveredArcs(mesh_, space_.graph, arcOfEdge_, graphs.front().tracks);
        std::ranges::copy(ownArcs(space_, subMesh), std::back_inserter(arcs));
        std::erase_if(arcs, [&](ArcId arc) { return present_[arc]; });
        sortUnique(arcs);
        ++searches_;
        const SubMeshChanges changes = changesOf(subMesh, arcs);
        if (changes.arcs) return *changes.arcs;
        if (changes.impossible && !space_.demands.empty())
            throw Error("sub-mesh " + std::to_string(subMesh.value()),
                        "no motorcycle graph obeys the constraints", "Take some out of /constraints");
        return straightArcs(subMesh, arcs);
    }

    /// The given arcs that are walked if every particle goes straight on.
    [[nodiscard]] std::vector<ArcId> straightArcs(SubMeshId subMesh, std::vector<ArcId> arcs) const {
        PresentArcs straight = present_;
        goStraight(space_, subMesh, straight);
        std::erase_if(arcs, [&](ArcId arc) { return !straight[arc]; });
        return arcs;
    }

    /// Searches the sub-mesh with these arcs free.
    [[nodiscard]] SubMeshChanges changesOf(SubMeshId subMesh, const std::vector<ArcId>& arcs) const {
        const Problem problem = subMeshProblem(space_, subMesh, arcs, present_);
        OptimumOptions options;
        options.work = limits_.work;
        const OptimumResult found = findOptimum(problem, options, control_);
        if (found.graphs.empty()) return {std::nullopt, found.complete};
        return {differences(problem, found.graphs.front(), present_)};
    }

    void searchComplete(SubMeshId subMesh) {
        const std::vector<Particle> particles(free_.in(subMesh).begin(), free_.in(subMesh).end());
        if (particles.empty()) return;
        for (const Linking linking : {Linking::closed, Linking::direct, Linking::none}) {
            const LinkedParticles movable = linkedParticles(space_, present_, particles, subMesh, linking);
            if (linking != Linking::none && movable.quasiComplexity >= limits_.complexity) continue;
            ++searches_;
            const SubMeshChanges changes = changesOf(subMesh, movable.arcs);
            if (!changes.arcs) continue;
            change(*changes.arcs);
            result_.linked += movable.linked;
            return;
        }
    }

    const QuadMesh& mesh_;
    const SubMeshes& subMeshes_;
    const SearchSpace& space_;
    const Enumeration& enumeration_;
    const GeneratorLimits& limits_;
    const Control& control_;
    const std::vector<ArcId> arcOfEdge_;
    PresentArcs present_;
    FreeParticles free_;
    std::vector<std::vector<ArcId>> rounds_; ///< arcs changed in every round, once per change
    mutable std::atomic<std::size_t> searches_ = 0;
    MergeResult result_;
};

} // namespace

GeneratedGraph generateGraph(const SearchedMesh& searched, const SearchSpace& space,
                             const Enumeration& enumeration, const GeneratorLimits& limits,
                             const Control& control) {
    Generator generator(searched, space, enumeration, limits, control);
    generator.partial();
    generator.complete();
    return generator.take();
}

} // namespace qm
