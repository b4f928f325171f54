// Compares searches in the search space of a sub-mesh with the same in that of the whole mesh: random meshes,
// seeds and cuts.
#include "base/at.h"
#include "base/infinity.h"
#include "enumerate/enumerate.h"
#include "enumerate/paper/coordinates.h"
#include "enumerate/state/assignment.h"
#include "enumerate/state/depth_first.h"
#include "enumerate/sub_mesh/search_space.h"
#include "layout/corners.h"
#include "layout/tracks.h"
#include "merge/free_particles.h"
#include "support/random_graph.h"
#include "support/random_problem.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <set>
#include <utility>

namespace qm::test {
namespace {

constexpr unsigned cases = 2000;

struct Case {
    QuadMesh mesh;
    BaseComplex complex;
    std::vector<double> edgeCosts;
    SubMeshes parts;
    SearchSpace space;
};

/// Random labels make the hardest cuts: particles leave and enter sub-meshes everywhere.
std::optional<Case> drawCase(std::mt19937& random) {
    std::optional<QuadMesh> mesh = randomMesh(random);
    if (!mesh) return std::nullopt;
    Case drawn;
    drawn.mesh = std::move(*mesh);
    drawn.complex = buildBaseComplex(drawn.mesh, randomSeeds(drawn.mesh, 3, random));
    std::uniform_real_distribution<double> cost(-1, 1);
    for (std::size_t edge = 0; edge < drawn.mesh.n_edges(); ++edge)
        drawn.edgeCosts.push_back(cost(random));
    drawn.parts = {std::vector<SubMeshId>(drawn.mesh.n_vertices()), 1 + static_cast<int>(random() % 3)};
    for (SubMeshId& label : drawn.parts.labels)
        label = SubMeshId(random() % at(drawn.parts.count));
    drawn.space = makeSearchSpace(drawn.mesh, drawn.complex, {drawn.edgeCosts, 0.5}, drawn.parts, {});
    return drawn;
}

/// Calls a test with every case that is a mesh, and with the random numbers used for it.
/// \param firstSeed  different for every test
template <class Test> void forEachCase(unsigned firstSeed, const Test& test) {
    for (unsigned number = 0; number < cases; ++number) {
        SCOPED_TRACE(number);
        std::mt19937 random(firstSeed + number);
        const std::optional<Case> drawn = drawCase(random);
        if (drawn) test(*drawn, random);
    }
}

/// All numbers of a problem, except the ids of arcs.
using Numbers = std::vector<double>;
Numbers numbersOf(const Problem& problem) {
    Numbers numbers(problem.costs.begin(), problem.costs.end());
    for (const ArcState domain : problem.domains)
        numbers.push_back(static_cast<double>(domain));
    const auto add = [&](auto... values) { (numbers.push_back(static_cast<double>(values)), ...); };
    for (const Chain& chain : problem.chains)
        add(chain.first.value(), chain.count, chain.coveredBefore, chain.coveredAfter);
    for (const CrackNode& node : problem.nodes)
        add(node.chain.value(), node.capacity);
    for (const Crossing& crossing : problem.crossings) {
        add(crossing.open, crossing.cornerCost);
        for (const CrossingSide& side : crossing.sides)
            add(side.before.value(), side.after.value(), side.node.value());
    }
    return numbers;
}

TEST(SubMeshProperty, ASubMeshesOwnLinesAreAllThatItsSearchNeeds) {
    int smaller = 0;
    forEachCase(0, [&](const Case& drawn, std::mt19937&) {
        const SearchSpace& whole = drawn.space;
        const PresentArcs none(whole.graph.arcs.size(), false);
        std::size_t lines = 0;
        for (const SubMeshId subMesh : drawn.parts.ids()) {
            const SearchSpace own = ownSpace(whole, subMesh);
            const PresentArcs ownNone(own.graph.arcs.size(), false);
            lines += own.graph.lines.size();
            if (own.graph.lines.size() < whole.graph.lines.size()) ++smaller;
            const Problem ownProblem = subMeshProblem(own, subMesh, ownArcs(own, subMesh), ownNone);
            const Problem wholeProblem = subMeshProblem(whole, subMesh, ownArcs(whole, subMesh), none);
            EXPECT_EQ(numbersOf(ownProblem), numbersOf(wholeProblem));
            PresentArcs ownStraight = ownNone, straight = none;
            goStraight(own, subMesh, ownStraight);
            goStraight(whole, subMesh, straight);
            EXPECT_EQ(assignmentOf(ownProblem, ownStraight), assignmentOf(wholeProblem, straight));
            const auto tracksOf = [&](const SearchSpace& space, const PresentArcs& present) {
                return graphOf({drawn.mesh, drawn.complex, space.graph}, present, drawn.edgeCosts,
                               walkersOf(space, subMesh, PresentArcs(present.size())))
                    .tracks;
            };
            const auto ownTracks = tracksOf(own, ownStraight), tracks = tracksOf(whole, straight);
            ASSERT_EQ(ownTracks.size(), tracks.size());
            for (std::size_t k = 0; k < tracks.size(); ++k)
                EXPECT_EQ(ownTracks[k].halfedges, tracks[k].halfedges);
        }
        EXPECT_LE(lines, 2 * whole.graph.lines.size());
    });
    EXPECT_GT(smaller, 20);
}

/// All graphs that a search visits; nothing if there are too many.
/// \param search  called with the visitor
template <class Search> std::optional<std::set<Assignment>> graphsOf(const Search& search) {
    std::set<Assignment> graphs;
    int visits = 0;
    const auto visit = [&](const Assignment& graph) {
        graphs.insert(graph);
        return ++visits < 3000;
    };
    return search(visit) ? std::optional(std::move(graphs)) : std::nullopt;
}

TEST(SubMeshProperty, ThePapersAlgorithmsFindTheSameGraphs) {
    int compared = 0, demanded = 0;
    forEachCase(6000, [&](const Case& drawn, std::mt19937& random) {
        for (const SubMeshId subMesh : drawn.parts.ids()) {
            SearchSpace own = ownSpace(drawn.space, subMesh);
            const PresentArcs none(own.graph.arcs.size(), false);
            const std::vector<ArcId> arcs = ownArcs(own, subMesh);
            if (arcs.empty()) continue;
            Problem problem = subMeshProblem(own, subMesh, arcs, none);
            const std::vector<VariableId> open = freeVariables(SearchState(problem));
            const bool demands = !open.empty() && random() % 2 == 0;
            if (demands)
                problem.domains[open[random() % open.size()]] =
                    random() % 2 == 0 ? ArcState::in : ArcState::out;
            const auto expected = graphsOf([&](const auto& visit) {
                return forEachAssignment(
                    problem, [] { return infinity; },
                    [&](const SearchState& state) { return visit(state.assignment()); });
            });
            for (const auto method : {CoordinateMethod::bounds, CoordinateMethod::improved}) {
                int questions = 0;
                const auto found = graphsOf([&](const auto& visit) {
                    return forEachCoordinateVector(problem, method, visit, [&] { return ++questions > 10; });
                });
                if (!expected || !found) continue;
                EXPECT_EQ(*found, *expected) << "method " << static_cast<int>(method);
                ++compared;
                demanded += demands ? 1 : 0;
            }
        }
    });
    EXPECT_GT(compared, 1000);
    EXPECT_GT(demanded, 200);
}

TEST(SubMeshProperty, GraphsCostWhatTheirTracksAndCornersDo) {
    std::size_t endsPastTheCut = 0;
    forEachCase(2000, [&](const Case& drawn, std::mt19937&) {
        EnumerationOptions options;
        options.cost.terms = {1, 0, 2, 0};
        options.best = 3;
        const Enumeration found =
            enumerateGraphs({drawn.mesh, drawn.complex, drawn.edgeCosts, drawn.parts, {}}, options);
        const Corners corners(drawn.mesh, drawn.parts);
        for (const SubMeshId subMesh : drawn.parts.ids())
            for (const MotorcycleGraph& graph : found.subMeshes[subMesh].graphs) {
                double cost = 0.5 * static_cast<double>(corners.between(graph.tracks, subMesh));
                for (const Track& track : graph.tracks) {
                    const VertexId end = drawn.mesh.to_vertex_handle(track.halfedges.back());
                    const SubMeshId label = drawn.parts.of(end);
                    cost += track.cost;
                    endsPastTheCut += drawn.mesh.is_boundary(end) && label != subMesh ? 1 : 0;
                }
                EXPECT_NEAR(graph.cost, cost, 1e-9);
            }
    });
    EXPECT_GT(endsPastTheCut, 100U);
}

TEST(SubMeshProperty, FreeParticlesAreKnownAfterEveryChange) {
    std::size_t met = 0;
    forEachCase(1000, [&](const Case& drawn, std::mt19937& random) {
        if (drawn.space.graph.arcs.empty()) return;
        const ArcGraph& graph = drawn.space.graph;
        PresentArcs present(graph.arcs.size(), false);
        FreeParticles free(drawn.space, present);
        for (int step = 0; step < 20; ++step) {
            std::vector<ArcId> changed;
            for (std::size_t arc = 0; arc < present.size(); ++arc)
                if (random() % 10 == 0) changed.emplace_back(arc);
            for (const ArcId arc : changed)
                present[arc].flip();
            free.update(changed);
            IdVector<SubMeshId, std::vector<Particle>> expected(at(drawn.parts.count));
            for (const Particle particle : freeParticles(graph, present)) {
                const JunctionId junction = freeEnd(graph, particle, present);
                expected[drawn.space.junctionLabels[junction]].push_back(particle);
            }
            std::size_t count = 0;
            for (const SubMeshId subMesh : drawn.parts.ids()) {
                const auto& in = free.in(subMesh);
                EXPECT_EQ(std::vector(in.begin(), in.end()), expected[subMesh]);
                count += in.size();
            }
            EXPECT_EQ(free.count(), count);
            met += count;
        }
    });
    EXPECT_GT(met, 1000U);
}

} // namespace
} // namespace qm::test
