// Compares the pruning program with trying every set of arcs, and with greedy removal.
#include "base/at.h"
#include "base/error.h"
#include "base/infinity.h"
#include "basecomplex/arc_graph.h"
#include "enumerate/paper/plain_graph.h"
#include "layout/borders.h"
#include "mesh/bounding_box.h"
#include "mesh/dihedral.h"
#include "mesh/quad_geometry.h"
#include "program/neighbourhood_search.h"
#include "program/solve_program.h"
#include "prune/prune_optimum.h"
#include "prune/vertex_room.h"
#include "support/layout_fault.h"
#include "support/polycube.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <random>

namespace qm::test {
namespace {

struct Case {
    QuadMesh mesh;
    BaseComplex complex;
    std::vector<double> angles;
    std::vector<double> costs;
    Layout layout;
};

/// \param curves  largest number of feature curves
std::optional<Case> drawCase(unsigned number, std::size_t curves) {
    std::mt19937 random(number);
    std::optional<QuadMesh> mesh = randomMesh(random);
    if (!mesh) return std::nullopt;
    Case drawn{std::move(*mesh), {}, {}, {}, {}};
    std::uniform_real_distribution<double> angle(0, 1);
    for (std::size_t edge = 0; edge < drawn.mesh.n_edges(); ++edge)
        drawn.angles.push_back(angle(random));
    drawn.costs = edgeCosts(drawn.angles, {0.9, 0.7});
    drawn.complex = buildBaseComplex(drawn.mesh, randomSeeds(drawn.mesh, curves, random));
    drawn.layout =
        buildLayout(drawn.mesh, plainMotorcycleGraph(drawn.mesh, drawn.complex, drawn.costs).tracks,
                    drawn.angles, drawn.costs);
    return drawn;
}

double objective(const Layout& layout, double beta) {
    return layout.cost + beta * static_cast<double>(layout.segments.size());
}

PruneOptions optimum(double beta, bool smooth) {
    PruneOptions options;
    options.method = PruneMethod::optimum;
    options.beta = beta;
    options.smooth = smooth;
    options.maxSharpTurn = 180; // adds no tracks, which no search has chosen
    return options;
}

constexpr double rho = 0.7; ///< sharp edges have larger angles

PruneResult pruneCase(const Case& drawn, const Layout& layout, const PruneOptions& options) {
    return prune({drawn.mesh, drawn.complex, drawn.angles, drawn.costs}, layout, options, rho);
}

/// The layouts of all sets of arcs that make one.
std::vector<Layout> allLayouts(const Case& drawn, const ArcGraph& graph) {
    std::vector<Layout> layouts;
    for (unsigned bits = 0; bits >> graph.arcs.size() == 0; ++bits) {
        std::vector<Track> tracks;
        for (std::size_t arc = 0; arc < graph.arcs.size(); ++arc) {
            if ((bits >> arc & 1U) == 0) continue;
            const auto halfedges = halfedgesOf(graph, drawn.complex, ArcId(arc));
            tracks.push_back({{halfedges.begin(), halfedges.end()}, 0});
            for (const HalfedgeId halfedge : halfedges)
                tracks.back().cost += drawn.costs[at(drawn.mesh.edge_handle(halfedge))];
        }
        try {
            layouts.push_back(buildLayout(drawn.mesh, tracks, drawn.angles, drawn.costs));
        } catch (const std::exception&) { // some segment is no grid
        }
    }
    return layouts;
}

/// A case with few arcs, so that all sets of arcs can be tried.
std::optional<Case> drawSmallCase(unsigned number, std::size_t curves) {
    std::optional<Case> drawn = drawCase(number, curves);
    if (!drawn) return std::nullopt;
    const std::size_t arcs = buildArcGraph(drawn->mesh, drawn->complex).arcs.size();
    return arcs > 0 && arcs <= 12 ? std::move(drawn) : std::nullopt;
}

class AllSetsOfArcs : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Curves, AllSetsOfArcs, ::testing::Values(0, 6));

TEST_P(AllSetsOfArcs, HaveNoneThatIsBetterThanTheOptimum) {
    std::size_t compared = 0, cheaper = 0, annuli = 0;
    for (unsigned number = 0; number < 600 && compared < 60; ++number) {
        const auto drawn = drawSmallCase(number, GetParam());
        if (!drawn) continue;
        ++compared;
        const auto all = allLayouts(*drawn, buildArcGraph(drawn->mesh, drawn->complex));
        for (const double beta : {0.0, 0.1, 0.7, 10.0, 1e3}) {
            const PruneResult pruned = pruneCase(*drawn, drawn->layout, optimum(beta, false));
            double lowest = infinity;
            for (const Layout& layout : all)
                lowest = std::min(lowest, objective(layout, beta));
            EXPECT_TRUE(pruned.proven);
            EXPECT_NEAR(objective(pruned.layout, beta), lowest, 1e-6) << "case " << number << ", " << beta;
            EXPECT_NEAR(*pruned.objectiveBound, lowest, 1e-6) << "case " << number << ", " << beta;
            if (pruned.layout.cost < drawn->layout.cost - 1e-6) ++cheaper;
            annuli += static_cast<std::size_t>(
                std::ranges::count_if(pruned.layout.tracks, &LayoutTrack::transversal));
        }
    }
    EXPECT_GT(compared, 10U);
    EXPECT_GT(cheaper, 3U);
    EXPECT_GT(annuli, 3U);
}

std::vector<bool> edgesOnTracks(const QuadMesh& mesh, const Layout& layout) {
    std::vector<bool> onTrack(mesh.n_edges());
    for (const Track& track : properTracks(layout))
        for (const HalfedgeId halfedge : track.halfedges)
            onTrack[at(mesh.edge_handle(halfedge))] = true;
    return onTrack;
}

/// One edge on a track of the layout, and one on an arc that has none.
Constraints drawConstraints(const Case& drawn, std::mt19937& random) {
    const std::vector<bool> onTrack = edgesOnTracks(drawn.mesh, drawn.layout);
    const ArcGraph graph = buildArcGraph(drawn.mesh, drawn.complex);
    const std::vector<ArcId> arcOf = arcsOfEdges(drawn.mesh, graph, drawn.complex);
    std::vector<EdgeId> edges(drawn.mesh.edges_begin(), drawn.mesh.edges_end());
    std::ranges::shuffle(edges, random);
    Constraints constraints;
    for (const EdgeId edge : edges)
        if (arcOf[at(edge)].valid())
            (onTrack[at(edge)] ? constraints.required : constraints.forbidden).push_back(edge);
    constraints.required.resize(std::min<std::size_t>(constraints.required.size(), 1));
    constraints.forbidden.resize(std::min<std::size_t>(constraints.forbidden.size(), 1));
    return constraints;
}

bool obeys(const Case& drawn, const Layout& layout, const Constraints& constraints) {
    const std::vector<bool> onTrack = edgesOnTracks(drawn.mesh, layout);
    const auto isOnTrack = [&](EdgeId edge) { return onTrack[at(edge)]; };
    return std::ranges::all_of(constraints.required, isOnTrack) &&
           std::ranges::none_of(constraints.forbidden, isOnTrack);
}

TEST_P(AllSetsOfArcs, HaveNoneThatObeysAndIsBetterThanTheOptimum) {
    std::mt19937 random(1);
    std::size_t compared = 0, dearer = 0;
    for (unsigned number = 0; number < 600 && compared < 60; ++number) {
        const auto drawn = drawSmallCase(number, GetParam());
        if (!drawn) continue;
        ++compared;
        PruneOptions options = optimum(1, false);
        const double free = objective(pruneCase(*drawn, drawn->layout, options).layout, options.beta);
        options.constraints = drawConstraints(*drawn, random);
        double lowest = infinity;
        for (const Layout& layout : allLayouts(*drawn, buildArcGraph(drawn->mesh, drawn->complex)))
            if (obeys(*drawn, layout, options.constraints))
                lowest = std::min(lowest, objective(layout, options.beta));
        const PruneResult pruned = pruneCase(*drawn, drawn->layout, options);
        EXPECT_TRUE(pruned.proven);
        EXPECT_TRUE(obeys(*drawn, pruned.layout, options.constraints)) << "case " << number;
        EXPECT_NEAR(objective(pruned.layout, options.beta), lowest, 1e-6) << "case " << number;
        if (lowest > free + 1e-6) ++dearer;
        options.method = PruneMethod::greedy;
        options.eta = -infinity;
        EXPECT_TRUE(obeys(*drawn, pruneCase(*drawn, drawn->layout, options).layout, options.constraints));
        std::swap(options.constraints.required, options.constraints.forbidden);
        EXPECT_THROW((void)pruneCase(*drawn, drawn->layout, options), Error);
    }
    EXPECT_GT(compared, 10U);
    EXPECT_GT(dearer, 3U);
}

/// Whether the corners at all extraordinary vertices have at least so many degrees.
bool hasRoom(const Case& drawn, const Layout& layout, double minCorner) {
    std::vector<bool> onTrack(drawn.mesh.n_edges());
    for (const LayoutTrack& track : layout.tracks)
        for (const HalfedgeId halfedge : track.track.halfedges)
            if (!track.transversal)
                onTrack[static_cast<std::size_t>(drawn.mesh.edge_handle(halfedge).idx())] = true;
    return std::ranges::all_of(drawn.complex.extraordinaryVertices, [&](VertexId vertex) {
        return std::ranges::all_of(
            roomAt(drawn.mesh, drawn.angles, vertex, minCorner), [&](const RoomSector& sector) {
                const auto missing = std::ranges::count_if(sector.edges, [&](HalfedgeId edge) {
                    return !onTrack[static_cast<std::size_t>(drawn.mesh.edge_handle(edge).idx())];
                });
                return static_cast<std::size_t>(missing) <= sector.maxMissing;
            });
    });
}

TEST_P(AllSetsOfArcs, HaveNoneWithRoomForCornersThatIsBetterThanTheOptimum) {
    std::size_t compared = 0, moreExpensive = 0;
    for (unsigned number = 0; number < 600 && compared < 60; ++number) {
        const auto drawn = drawSmallCase(number, GetParam());
        if (!drawn) continue;
        ++compared;
        const auto all = allLayouts(*drawn, buildArcGraph(drawn->mesh, drawn->complex));
        for (const double minCorner : {25.0, 80.0}) {
            constexpr double beta = 10;
            PruneOptions options = optimum(beta, true);
            options.maxTurn = 180;
            options.minCorner = minCorner;
            const PruneResult pruned = pruneCase(*drawn, drawn->layout, options);
            double lowest = infinity, lowestOfAll = lowest;
            for (const Layout& layout : all) {
                lowestOfAll = std::min(lowestOfAll, objective(layout, beta));
                if (hasRoom(*drawn, layout, minCorner)) lowest = std::min(lowest, objective(layout, beta));
            }
            EXPECT_TRUE(hasRoom(*drawn, pruned.layout, minCorner)) << "case " << number;
            EXPECT_NEAR(objective(pruned.layout, beta), lowest, 1e-6) << "case " << number;
            if (lowest > lowestOfAll + 1e-6) ++moreExpensive;
            options.eta = -1e9;
            const Layout greedy = pruneLayout({drawn->mesh, drawn->complex, drawn->angles, drawn->costs},
                                              drawn->layout, options)
                                      .layout;
            EXPECT_TRUE(hasRoom(*drawn, greedy, minCorner)) << "case " << number;
        }
    }
    EXPECT_GT(compared, 10U);
    EXPECT_GT(moreExpensive, 3U);
}

TEST_P(AllSetsOfArcs, HaveNoneOfFewerPatchesThanTheFewest) {
    std::size_t compared = 0;
    for (unsigned number = 0; number < 600 && compared < 60; ++number) {
        const auto drawn = drawSmallCase(number, GetParam());
        if (!drawn) continue;
        ++compared;
        PruneOptions options = optimum(1, false);
        options.fewestPatches = true;
        const PruneResult pruned = pruneCase(*drawn, drawn->layout, options);
        const auto key = [](const Layout& layout) { return std::pair(layout.segments.size(), layout.cost); };
        auto fewest = key(drawn->layout);
        for (const Layout& layout : allLayouts(*drawn, buildArcGraph(drawn->mesh, drawn->complex)))
            fewest = std::min(fewest, key(layout));
        EXPECT_TRUE(pruned.proven);
        EXPECT_EQ(pruned.layout.segments.size(), fewest.first) << "case " << number;
        EXPECT_NEAR(pruned.layout.cost, fewest.second, 1e-6) << "case " << number;
        EXPECT_EQ(*pruned.objectiveBound, static_cast<double>(fewest.first)) << "case " << number;
    }
    EXPECT_GT(compared, 10U);
}

TEST(PruneProperty, TheOptimumIsNeverWorseThanGreedyRemovalAndCountsItsSegments) {
    for (unsigned number = 0; number < 60; ++number) {
        const auto drawn = drawCase(number, number % 2 == 0 ? 0 : 12);
        if (!drawn) continue;
        for (const bool smooth : {false, true})
            for (const double beta : {0.0, 0.5, 10.0, 1e3}) {
                PruneOptions greedy;
                greedy.eta = -beta;
                greedy.smooth = smooth;
                greedy.maxSharpTurn = 180;
                const Layout removed = pruneCase(*drawn, drawn->layout, greedy).layout;
                const PruneResult best = pruneCase(*drawn, drawn->layout, optimum(beta, smooth));
                EXPECT_LE(objective(best.layout, beta), objective(removed, beta) + 1e-6) << "case " << number;
                EXPECT_GE(objective(best.layout, beta), *best.objectiveBound - 1e-6) << "case " << number;
                if (best.proven) {
                    EXPECT_NEAR(objective(best.layout, beta), *best.objectiveBound, 1e-6)
                        << "case " << number;
                }
                if (beta == 1e3) {
                    EXPECT_LE(best.layout.segments.size(), removed.segments.size()) << "case " << number;
                }
            }
    }
}

/// Whether an edge belongs to no round part, and rounding moves the surface by more than 0.1% of the
/// diagonal.
bool wouldBeRoundedOff(const QuadMesh& mesh, const std::vector<double>& angles, EdgeId edge) {
    if (mesh.is_boundary(edge)) return false;
    double width = infinity;
    for (const unsigned side : {0U, 1U}) {
        const HalfedgeId halfedge = mesh.halfedge_handle(edge, side);
        if (isFolded(mesh, mesh.face_handle(halfedge))) return false;
        width = std::min(width, (mesh.calc_edge_length(mesh.next_halfedge_handle(halfedge)) +
                                 mesh.calc_edge_length(mesh.prev_halfedge_handle(halfedge))) /
                                    2);
    }
    const double angle = angles[static_cast<std::size_t>(edge.idx())];
    return angle > 1.2 && width * angle / 8 > 0.001 * boundingBox(mesh).diagonal();
}

TEST(PruneProperty, NoEdgeThatWouldBeRoundedOffIsInsideASegment) {
    std::size_t added = 0;
    for (unsigned number = 0; number < 60; ++number) {
        auto drawn = drawCase(number, 6);
        if (!drawn || drawn->complex.separatrices.empty()) continue;
        for (double& angle : drawn->angles)
            angle *= 1.5;
        for (const PruneMethod method : {PruneMethod::greedy, PruneMethod::optimum}) {
            PruneOptions options;
            options.method = method;
            const PruneResult pruned = pruneCase(*drawn, drawn->layout, options);
            added += pruned.addedTracks;
            EXPECT_EQ(layoutFault(drawn->mesh, pruned.layout), "") << "case " << number;
            const Borders borders(drawn->mesh, properTracks(pruned.layout));
            for (const EdgeId edge : drawn->mesh.edges())
                EXPECT_TRUE(borders.isBorder(edge) || !wouldBeRoundedOff(drawn->mesh, drawn->angles, edge))
                    << "case " << number << ", edge " << edge.idx();
        }
    }
    EXPECT_GT(added, 50U);
}

TEST(PruneProperty, WhatIsPrunedCanBePrunedToTheOptimum) {
    for (unsigned number = 0; number < 80; ++number) {
        const auto drawn = drawCase(number, 6);
        if (!drawn) continue;
        PruneOptions rough;
        rough.eta = -1e9;
        rough.smooth = false;
        const Layout removed =
            pruneLayout({drawn->mesh, drawn->complex, drawn->angles, drawn->costs}, drawn->layout, rough)
                .layout;
        const PruneResult best = pruneCase(*drawn, removed, optimum(0.5, true));
        EXPECT_LE(objective(best.layout, 0.5), objective(removed, 0.5) + 1e-6) << "case " << number;
    }
}

TEST(PruneProperty, TheNumberOfSegmentsIsKept) {
    std::size_t limited = 0;
    for (unsigned number = 0; number < 40; ++number) {
        const auto drawn = drawCase(number, 0);
        if (!drawn) continue;
        PruneOptions options = optimum(100, false);
        const std::size_t fewest = pruneCase(*drawn, drawn->layout, options).layout.segments.size();
        options.maxSegments = static_cast<double>(fewest);
        const PruneResult few = pruneCase(*drawn, drawn->layout, options);
        EXPECT_LE(few.layout.segments.size(), fewest) << "case " << number;
        if (fewest < drawn->layout.segments.size()) ++limited;
    }
    EXPECT_GT(limited, 3U);
}

TEST(PruneProperty, NothingOnTheFrontIsBeaten) {
    std::size_t several = 0;
    for (unsigned number = 0; number < 30; ++number) {
        const auto drawn = drawCase(number, number % 8);
        if (!drawn) continue;
        PruneOptions options = optimum(1, false);
        options.front = true;
        const auto front = pruneCase(*drawn, drawn->layout, options).front;
        ASSERT_FALSE(front.empty());
        for (std::size_t k = 1; k < front.size(); ++k) {
            EXPECT_LE(front[k].segments, front[k - 1].segments);
            EXPECT_TRUE(front[k].cost > front[k - 1].cost || front[k].segments == front[k - 1].segments ||
                        front[k].capturedSharpness > front[k - 1].capturedSharpness);
            EXPECT_TRUE(front[k].segments < front[k - 1].segments || front[k].cost != front[k - 1].cost);
        }
        for (const FrontPoint& point : front) {
            EXPECT_TRUE(point.proven);
            EXPECT_NEAR(point.cost + point.beta * static_cast<double>(point.segments), point.objectiveBound,
                        1e-6);
        }
        several += front.size() > 1 ? 1 : 0;
    }
    EXPECT_GT(several, 2U);
}

/// A ring of items, where at least two out of three neighbours must be taken; larger than the first
/// neighbourhoods.
IntegerProgram largeRing(int size) {
    IntegerProgram ring;
    for (int column = 0; column < size; ++column) {
        ring.costs.push_back(1 + column * 7 % 11);
        ring.rows.push_back({{ColumnId(column), ColumnId((column + 1) % size), ColumnId((column + 2) % size)},
                             {1, 1, 1},
                             2,
                             3});
    }
    return ring;
}

TEST(PruneProperty, NeighbourhoodsComeToTheOptimum) {
    const IntegerProgram ring = largeRing(700);
    const ColumnValues all(ring.costs.size(), 1);
    const ColumnValues better =
        improveByNeighbourhoods(ring, all, {{ColumnId(0), ColumnId(1), ColumnId(2)}}, {});
    EXPECT_TRUE(ring.allows(better));
    const ProgramSolution best = solveProgram(ring, {}, {});
    ASSERT_TRUE(best.proven);
    EXPECT_NEAR(ring.cost(better), ring.cost(*best.values), 1e-6);
}

TEST(PruneProperty, NeighbourhoodsFollowTheirSeed) {
    const IntegerProgram ring = largeRing(700);
    const ColumnValues all(ring.costs.size(), 1);
    const auto improved = [&](std::uint32_t seed) {
        Control control; // stops after a few neighbourhoods
        control.stopRequested = [asked = 0]() mutable { return ++asked > 500; };
        return improveByNeighbourhoods(ring, all, {}, {.columns = 30, .seed = seed}, control);
    };
    EXPECT_EQ(improved(1), improved(1));
    EXPECT_NE(improved(1), improved(2));
}

TEST(PruneProperty, ALimitOfNodesEndsASearch) {
    // Even weights never add up to an odd number, but neither the relaxation nor cuts can tell.
    IntegerProgram uneven;
    uneven.costs.assign(15, 1);
    uneven.rows.resize(1, {{}, std::vector<double>(15, 2), 15, 15});
    const auto columns = uneven.costs.ids();
    uneven.rows.front().columns.assign(columns.begin(), columns.end());
    const ProgramSolution whole = solveProgram(uneven, {}, {}), cut = solveProgram(uneven, {}, {.nodes = 3});
    EXPECT_GT(whole.lowerBound, 15); // above every cost, because there is no solution
    EXPECT_LT(cut.lowerBound, 15);
}

TEST(PruneProperty, AProgramStopsWhenItIsAskedTo) {
    const IntegerProgram ring = largeRing(700);
    const ProgramSolution best = solveProgram(ring, {}, {});
    ASSERT_TRUE(best.proven);
    for (int limit = 1; limit < 5'000; limit *= 2) {
        Control control;
        control.stopRequested = [&, asked = 0]() mutable { return ++asked > limit; };
        const ProgramSolution found = solveProgram(ring, {}, {}, control);
        EXPECT_LE(found.lowerBound, best.lowerBound + 1e-6) << limit;
        EXPECT_TRUE(!found.values || ring.allows(*found.values)) << limit;
        EXPECT_TRUE(!found.proven || found.lowerBound > best.lowerBound - 1e-6) << limit;
    }
}

TEST(PruneProperty, SignalsAreLeftToTheCaller) {
    const auto own = +[](int) {};
    const auto before = std::signal(SIGINT, own);
    bool isKept = true;
    Control control;
    control.stopRequested = [&] {
        struct sigaction present {};
        sigaction(SIGINT, nullptr, &present);
        isKept = isKept && present.sa_handler == own;
        return false;
    };
    EXPECT_TRUE(solveProgram(largeRing(700), {}, {}, control).proven);
    EXPECT_TRUE(isKept);
    std::signal(SIGINT, before);
}

TEST(PruneProperty, NeighbourhoodsStopWhenTheyAreAskedTo) {
    const IntegerProgram ring = largeRing(700);
    const ColumnValues all(ring.costs.size(), 1);
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
    const PruneResult pruned = prune({mesh, complex, angles, costs}, layout, options, rho);
    EXPECT_LE(pruned.layout.cost + static_cast<double>(pruned.layout.segments.size()),
              layout.cost + static_cast<double>(layout.segments.size()) + 1e-6);
}

} // namespace
} // namespace qm::test
