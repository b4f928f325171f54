// Pruning as an integer program against trying every set of arcs, and against the greedy removal.
#include "basecomplex/arc_graph.h"
#include "enumerate/paper/plain_graph.h"
#include "mesh/dihedral.h"
#include "program/neighbourhood_search.h"
#include "program/solve_program.h"
#include "prune/prune_optimum.h"
#include "support/polycube.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace qm::testing {
namespace {

struct Case {
    QuadMesh mesh;
    BaseComplex complex;
    std::vector<double> angles;
    std::vector<double> costs;
    Layout layout;
};

std::optional<Case> drawCase(unsigned number) {
    std::mt19937 random(number);
    std::optional<QuadMesh> mesh = randomMesh(random);
    if (!mesh) return std::nullopt;
    Case drawn{std::move(*mesh), {}, {}, {}, {}};
    std::uniform_real_distribution<double> angle(0, 1);
    for (std::size_t edge = 0; edge < drawn.mesh.n_edges(); ++edge)
        drawn.angles.push_back(angle(random));
    drawn.costs = edgeCosts(drawn.angles, {0.9, 0.7});
    drawn.complex = buildBaseComplex(drawn.mesh);
    drawn.layout =
        buildLayout(drawn.mesh, plainMotorcycleGraph(drawn.mesh, drawn.complex, drawn.costs).tracks,
                    drawn.angles, drawn.costs);
    return drawn;
}

std::size_t transversals(const Layout& layout) {
    return static_cast<std::size_t>(
        std::ranges::count_if(layout.tracks, [](const LayoutTrack& track) { return track.transversal; }));
}

PruneOptions optimum(double beta, bool smooth) {
    PruneOptions options;
    options.method = PruneMethod::optimum;
    options.beta = beta;
    options.smooth = smooth;
    return options;
}

/// Tries all sets of arcs.
/// \return the least objective of those that cut the mesh into grids
double minOverAll(const Case& drawn, const ArcGraph& graph, double beta) {
    double min = std::numeric_limits<double>::infinity();
    for (unsigned bits = 0; bits >> graph.arcs.size() == 0; ++bits) {
        std::vector<Track> tracks;
        for (std::size_t arc = 0; arc < graph.arcs.size(); ++arc) {
            if ((bits >> arc & 1U) == 0) continue;
            const auto halfedges = halfedgesOf(graph, drawn.complex, ArcId(arc));
            tracks.push_back({{halfedges.begin(), halfedges.end()}, 0});
            for (const HalfedgeId halfedge : halfedges)
                tracks.back().cost +=
                    drawn.costs[static_cast<std::size_t>(drawn.mesh.edge_handle(halfedge).idx())];
        }
        try {
            const Layout layout = buildLayout(drawn.mesh, tracks, drawn.angles, drawn.costs);
            const auto grids = static_cast<double>(layout.segments.size() - transversals(layout));
            min = std::min(min, layout.cost + beta * grids);
        } catch (const std::exception&) { // no grids
        }
    }
    return min;
}

TEST(PruneProperty, TheOptimumIsThatOfAllSetsOfArcs) {
    std::size_t compared = 0, cheaper = 0;
    for (unsigned number = 0; number < 400 && compared < 40; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        const ArcGraph graph = buildArcGraph(drawn->mesh, drawn->complex);
        if (graph.arcs.empty() || graph.arcs.size() > 12) continue;
        const double beta = number % 3 == 0 ? 0 : 0.7;
        const PruneResult pruned = pruneToOptimum(drawn->mesh, drawn->complex, drawn->layout, drawn->angles,
                                                  drawn->costs, optimum(beta, false));
        const auto grids = static_cast<double>(pruned.layout.segments.size() - transversals(pruned.layout));
        ++compared;
        EXPECT_TRUE(pruned.proven);
        EXPECT_NEAR(pruned.layout.cost + beta * grids, minOverAll(*drawn, graph, beta), 1e-6)
            << "case " << number;
        EXPECT_NEAR(*pruned.objectiveBound, pruned.layout.cost + beta * grids, 1e-6) << "case " << number;
        if (pruned.layout.cost < drawn->layout.cost - 1e-6) ++cheaper;
    }
    EXPECT_GT(compared, 10U);
    EXPECT_GT(cheaper, 3U);
}

TEST(PruneProperty, TheOptimumIsNeverWorseThanGreedyRemovalAndCountsItsSegments) {
    for (unsigned number = 0; number < 200; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        for (const bool smooth : {false, true}) {
            PruneOptions greedy;
            greedy.eta = -1e9;
            greedy.smooth = smooth;
            const PruneResult removed =
                pruneLayout(drawn->mesh, drawn->layout, drawn->angles, drawn->costs, greedy);
            const PruneResult best = pruneToOptimum(drawn->mesh, drawn->complex, drawn->layout, drawn->angles,
                                                    drawn->costs, optimum(0.5, smooth));
            const auto objective = [](const Layout& layout) {
                return layout.cost + 0.5 * static_cast<double>(layout.segments.size() - transversals(layout));
            };
            EXPECT_LE(objective(best.layout), objective(drawn->layout) + 1e-6) << "case " << number;
            if (!smooth) {
                EXPECT_LE(objective(best.layout), objective(removed.layout) + 1e-6) << "case " << number;
            }
        }
    }
}

TEST(PruneProperty, TheNumberOfSegmentsIsKept) {
    std::size_t limited = 0;
    for (unsigned number = 0; number < 70; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        PruneOptions options = optimum(100, false);
        const std::size_t fewest =
            pruneToOptimum(drawn->mesh, drawn->complex, drawn->layout, drawn->angles, drawn->costs, options)
                .layout.segments.size();
        options.maxSegments = static_cast<double>(fewest);
        const PruneResult few =
            pruneToOptimum(drawn->mesh, drawn->complex, drawn->layout, drawn->angles, drawn->costs, options);
        EXPECT_LE(few.layout.segments.size() - transversals(few.layout), fewest) << "case " << number;
        if (fewest < drawn->layout.segments.size()) ++limited;
    }
    EXPECT_GT(limited, 5U);
}

TEST(PruneProperty, NothingOnTheFrontIsBeaten) {
    std::size_t several = 0;
    for (unsigned number = 0; number < 60; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        const auto front = pruneFront(drawn->mesh, drawn->complex, drawn->layout, drawn->angles, drawn->costs,
                                      optimum(1, false), 0.7);
        ASSERT_FALSE(front.empty());
        for (std::size_t k = 1; k < front.size(); ++k) {
            EXPECT_LE(front[k].segments, front[k - 1].segments);
            EXPECT_TRUE(front[k].cost > front[k - 1].cost || front[k].segments == front[k - 1].segments ||
                        front[k].capturedSharpness > front[k - 1].capturedSharpness);
            EXPECT_TRUE(front[k].segments < front[k - 1].segments || front[k].cost != front[k - 1].cost);
        }
        several += front.size() > 1 ? 1 : 0;
    }
    EXPECT_GT(several, 3U);
}

/// Items of which two out of three neighbours are wanted: a ring that is larger than the first
/// neighbourhoods.
IntegerProgram largeRing(int size) {
    IntegerProgram ring;
    for (int column = 0; column < size; ++column) {
        ring.costs.push_back(1 + column * 7 % 11);
        ring.rows.push_back({{column, (column + 1) % size, (column + 2) % size}, {1, 1, 1}, 2, 3});
    }
    return ring;
}

TEST(PruneProperty, NeighbourhoodsComeToTheOptimum) {
    const IntegerProgram ring = largeRing(700);
    const std::vector<double> all(ring.costs.size(), 1);
    const std::vector<double> better = improveByNeighbourhoods(ring, all, {{0, 1, 2}}, {});
    EXPECT_TRUE(ring.allows(better));
    const ProgramSolution best = solveProgram(ring, {}, {});
    ASSERT_TRUE(best.proven);
    EXPECT_NEAR(ring.cost(better), ring.cost(*best.values), 1e-6);
}

TEST(PruneProperty, NeighbourhoodsFollowTheirSeed) {
    const IntegerProgram ring = largeRing(700);
    const std::vector<double> all(ring.costs.size(), 1);
    const auto improved = [&](std::uint32_t seed) {
        Control control; // ends after a few neighbourhoods
        control.stopRequested = [asked = 0]() mutable { return ++asked > 20; };
        return improveByNeighbourhoods(ring, all, {}, {.columns = 30, .seed = seed}, control);
    };
    EXPECT_EQ(improved(1), improved(1));
    EXPECT_NE(improved(1), improved(2));
}

TEST(PruneProperty, ALimitOfNodesEndsASearch) {
    // Two of an odd number all around: of such a sum neither relaxation nor cuts know that it cannot be met.
    IntegerProgram uneven;
    uneven.costs.assign(15, 1);
    uneven.rows.resize(1, {{}, std::vector<double>(15, 2), 15, 15});
    uneven.rows[0].columns.resize(15);
    std::iota(uneven.rows[0].columns.begin(), uneven.rows[0].columns.end(), 0);
    const ProgramSolution whole = solveProgram(uneven, {}, {}), cut = solveProgram(uneven, {}, {.nodes = 3});
    EXPECT_GT(whole.lowerBound, 15); // no values cost so much: there are none
    EXPECT_LT(cut.lowerBound, 15);
}

TEST(PruneProperty, NeighbourhoodsStopWhenTheyAreAskedTo) {
    const IntegerProgram ring = largeRing(700);
    const std::vector<double> all(ring.costs.size(), 1);
    EXPECT_EQ(improveByNeighbourhoods(ring, all, {}, {.seconds = 0}), all);
    Control control;
    int asked = 0;
    control.stopRequested = [&asked] { return ++asked > 3; };
    EXPECT_TRUE(ring.allows(improveByNeighbourhoods(ring, all, {}, {}, control)));
}

TEST(PruneProperty, AStoppedSearchKeepsTheLayout) {
    const QuadMesh mesh = quadMesh(polycube(bump(), 3));
    const std::vector<double> angles = dihedralAngles(mesh), costs = edgeCosts(angles, {});
    const BaseComplex complex = buildBaseComplex(mesh);
    const Layout layout = buildLayout(mesh, plainMotorcycleGraph(mesh, complex, costs).tracks, angles, costs);
    PruneOptions options = optimum(1, false);
    options.timeLimit = 0;
    const PruneResult pruned = pruneToOptimum(mesh, complex, layout, angles, costs, options);
    EXPECT_LE(pruned.layout.cost + static_cast<double>(pruned.layout.segments.size()),
              layout.cost + static_cast<double>(layout.segments.size()) + 1e-6);
}

} // namespace
} // namespace qm::testing
