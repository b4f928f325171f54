#include "enumerate/paper/plain_graph.h"
#include "mesh/dihedral.h"
#include "prune/prune.h"
#include "support/layout_fault.h"
#include "support/polycube.h"
#include "support/random_graph.h"
#include "support/track_along.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace qm::test {
namespace {

PruneOptions bold(double eta = -1e9) {
    PruneOptions options;
    options.eta = eta;
    options.smooth = false;
    return options;
}

PruneResult prune(const QuadMesh& mesh, const std::vector<Track>& tracks, const PruneOptions& options,
                  const Control& control = {}) {
    const PerEdge none(mesh, 0);
    const Layout layout = buildLayout(mesh, tracks, none, none);
    PruneResult result = pruneLayout({mesh, {}, none, none}, layout, options, control);
    EXPECT_EQ(layoutFault(mesh, result.layout), "");
    return result;
}

std::vector<Path> keptPaths(const QuadMesh& mesh, const PruneResult& result) {
    std::vector<Path> paths;
    for (const Track& track : properTracks(result.layout))
        paths.push_back(pathOf(mesh, track));
    return paths;
}

TEST(Prune, RemovesOnlyWhatCostsMoreThanEta) {
    const QuadMesh mesh = rectangle(3, 1);
    const std::vector<Track> tracks{trackAlong(mesh, {1, 5}, 1), trackAlong(mesh, {2, 6}, 1.5)};
    const PruneResult result = prune(mesh, tracks, bold(1));
    EXPECT_EQ(keptPaths(mesh, result), (std::vector<Path>{{1, 5}}));
    EXPECT_EQ(result.removedTracks, 1U);
    EXPECT_EQ(result.keptNotQuadrilateral, 0U);
    EXPECT_DOUBLE_EQ(result.layout.cost, 1);
    EXPECT_EQ(result.layout.segments.size(), 2U);
}

TEST(Prune, TakesTheDearerOfTwoAndOfEqualOnesTheFirst) {
    // Squares at the lower left, lower right and upper left of vertex 4, which is reflex; 1 and 3 lie on its
    // lines.
    const QuadMesh mesh =
        quadMesh({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}},
                  {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}}});
    const auto kept = [&](double down, double left) {
        return keptPaths(
            mesh, prune(mesh, {trackAlong(mesh, {4, 1}, down), trackAlong(mesh, {4, 3}, left)}, bold()));
    };
    EXPECT_EQ(kept(1, 2), (std::vector<Path>{{4, 1}}));
    EXPECT_EQ(kept(2, 1), (std::vector<Path>{{4, 3}}));
    EXPECT_EQ(kept(1, 1), (std::vector<Path>{{4, 3}}));
}

TEST(Prune, KeepsWhatHoldsAnotherTrackUp) {
    const QuadMesh mesh = rectangle(2, 2);
    const PruneResult result =
        prune(mesh, {trackAlong(mesh, {1, 4, 7}, 3), trackAlong(mesh, {4, 5}, 1)}, bold(2));
    EXPECT_EQ(result.layout.segments.size(), 3U);
    EXPECT_EQ(result.removedTracks, 0U);
    EXPECT_EQ(result.keptNotQuadrilateral, 1U);
}

TEST(Prune, ComesBackToATrackThatHasBecomeFree) {
    const QuadMesh mesh = rectangle(4, 4);
    // Each track ends on the previous one, and is cheaper.
    const std::vector<Track> stairs{trackAlong(mesh, {2, 7, 12, 17, 22}, 4),
                                    trackAlong(mesh, {12, 13, 14}, 3), trackAlong(mesh, {13, 18, 23}, 2),
                                    trackAlong(mesh, {18, 19}, 1)};
    const PruneResult all = prune(mesh, stairs, bold());
    EXPECT_EQ(all.removedTracks, 4U);
    EXPECT_EQ(all.layout.segments.size(), 1U);
    EXPECT_EQ(all.keptNotQuadrilateral, 0U);
    const PruneResult none = prune(mesh, stairs, bold(1));
    EXPECT_EQ(none.removedTracks, 0U);
    EXPECT_EQ(none.keptNotQuadrilateral, 3U);
}

TEST(Prune, RemovesALineAcrossAnother) {
    const QuadMesh mesh = rectangle(2, 2);
    const PruneResult result =
        prune(mesh, {trackAlong(mesh, {1, 4, 7}, 3), trackAlong(mesh, {3, 4, 5}, 1)}, bold(2));
    EXPECT_EQ(keptPaths(mesh, result), (std::vector<Path>{{3, 4, 5}}));
    EXPECT_EQ(result.layout.segments.size(), 2U);
}

TEST(Prune, LeavesATJointOfACrossingOfThree) {
    // Two tracks meet head-on where the third one crosses; if one of them is removed, the other ends on the
    // third.
    const QuadMesh mesh = rectangle(2, 2);
    const PruneResult result = prune(
        mesh, {trackAlong(mesh, {1, 4, 7}, 1), trackAlong(mesh, {3, 4}, 3), trackAlong(mesh, {5, 4}, 1)},
        bold(2));
    EXPECT_EQ(keptPaths(mesh, result), (std::vector<Path>{{1, 4, 7}, {5, 4}}));
    // If nothing crosses, the remaining track would have an open end.
    const PruneResult open = prune(mesh, {trackAlong(mesh, {3, 4}, 3), trackAlong(mesh, {5, 4}, 1)}, bold());
    EXPECT_EQ(open.keptNotQuadrilateral, 2U);
}

TEST(Prune, KeepsALineWithOneSegmentOnBothSides) {
    const QuadMesh mesh = quadMesh(tube(4, 2));
    const PruneResult result = prune(mesh, {trackAlong(mesh, {0, 4, 8})}, bold());
    EXPECT_EQ(result.removedTracks, 0U);
    EXPECT_EQ(result.keptNotQuadrilateral, 1U);
    // One of two crossing lines can be removed.
    EXPECT_EQ(prune(mesh, {trackAlong(mesh, {0, 4, 8}), trackAlong(mesh, {2, 6, 10})}, bold()).removedTracks,
              1U);
}

TEST(Prune, KeepsALoopBetweenRings) {
    const QuadMesh mesh = quadMesh(tube(4, 2));
    const PruneResult result = prune(mesh, {trackAlong(mesh, {4, 5, 6, 7, 4}, 2)}, bold());
    EXPECT_EQ(result.removedTracks, 0U);
    EXPECT_EQ(result.keptNotQuadrilateral, 1U) << "transversals are not even candidates";
    EXPECT_EQ(result.layout.tracks.size(), 3U);
}

TEST(Prune, RemovesALoopWithOneCrossing) {
    // Rings through 0 and 8, and between them lines down column 1 that end on the rings.
    const QuadMesh mesh = quadMesh(torus(4, 4));
    const std::vector<Track> tracks{trackAlong(mesh, {0, 1, 2, 3, 0}, 5), trackAlong(mesh, {8, 9, 10}),
                                    trackAlong(mesh, {8, 11, 10}), trackAlong(mesh, {9, 5, 1}),
                                    trackAlong(mesh, {9, 13, 1})};
    const PruneResult result = prune(mesh, tracks, bold(1));
    EXPECT_EQ(result.removedTracks, 1U);
    EXPECT_EQ(result.layout.segments.size(), 1U);
}

TEST(Prune, RestsNothingOnATransversal) {
    // Between the rings through 0 and 6, a track leads up column 1 and ends at 1. The transversal of the
    // other half continues from there, but will be drawn anew. Without the ring through 0 the track would
    // have an open end.
    const QuadMesh mesh = quadMesh(torus(3, 3));
    const std::vector<Track> tracks{trackAlong(mesh, {1, 2, 0, 1}, 5), trackAlong(mesh, {6, 7, 8}),
                                    trackAlong(mesh, {6, 8}), trackAlong(mesh, {7, 4, 1})};
    PerEdge costs(mesh, 1);
    costs.along({7, 1}, -1);
    const Layout layout = buildLayout(mesh, tracks, PerEdge(mesh, 0), costs);
    ASSERT_EQ(layout.tracks.size(), 5U);
    ASSERT_TRUE(layout.tracks[4].transversal);
    const PruneResult result = pruneLayout({mesh, {}, PerEdge(mesh, 0), costs}, layout, bold(1));
    EXPECT_EQ(layoutFault(mesh, result.layout), "");
    EXPECT_EQ(result.removedTracks, 0U);
    EXPECT_EQ(result.keptNotQuadrilateral, 1U);
}

TEST(Prune, HandsOverWhatItHasWhenItIsStopped) {
    const QuadMesh mesh = rectangle(4, 1);
    const std::vector<Track> tracks{trackAlong(mesh, {1, 6}, 3), trackAlong(mesh, {2, 7}, 2),
                                    trackAlong(mesh, {3, 8}, 1)};
    int asked = 0;
    Control control;
    control.stopRequested = [&] { return ++asked > 2; };
    EXPECT_EQ(keptPaths(mesh, prune(mesh, tracks, bold(), control)), (std::vector<Path>{{3, 8}}));
}

// Two quads, folded along their common edge by the given degrees at each end.
QuadMesh folded(double left, double right) {
    const auto tip = [](double degrees, double x) {
        const double angle = degrees * std::numbers::pi / 180;
        return std::array{x, 1 + std::cos(angle), std::sin(angle)};
    };
    return quadMesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, tip(left, 0), tip(right, 1)},
                     {{0, 1, 3, 2}, {2, 3, 5, 4}}});
}

bool removesFold(double left, double right, double maxTurn, bool smooth = true) {
    const QuadMesh mesh = folded(left, right);
    PruneOptions options;
    options.eta = 0;
    options.smooth = smooth;
    options.maxTurn = maxTurn;
    const PruneResult result = prune(mesh, {trackAlong(mesh, {2, 3}, 1)}, options);
    EXPECT_EQ(result.removedTracks + result.keptNotSmooth, 1U);
    EXPECT_EQ(result.keptNotQuadrilateral, 0U);
    return result.removedTracks == 1;
}

TEST(PruneSmooth, AllowsTheBorderToTurnAsMuchAsIsSaid) {
    EXPECT_TRUE(removesFold(0, 0, 0.001));
    EXPECT_TRUE(removesFold(24.9, 24.9, 25));
    EXPECT_FALSE(removesFold(25.1, 25.1, 25));
    EXPECT_TRUE(removesFold(-24.9, 24.9, 25));
    EXPECT_FALSE(removesFold(170, 0, 169));
    EXPECT_TRUE(removesFold(170, 0, 171));
    EXPECT_TRUE(removesFold(170, 170, 25, false));
}

TEST(PruneSmooth, LooksAtBothEnds) {
    EXPECT_FALSE(removesFold(26, 0, 25));
    EXPECT_FALSE(removesFold(0, 26, 25));
}

TEST(PruneSmooth, MeasuresAtAnExtraordinaryVertexToo) {
    // All corners of a cube have three edges; if one is removed, the border turns by a right angle there.
    const QuadMesh mesh = quadMesh(polycube(box(1, 1, 1), 2));
    const std::vector<double> angles = dihedralAngles(mesh), costs = edgeCosts(angles, {});
    const Layout layout =
        buildLayout(mesh, plainMotorcycleGraph(mesh, buildBaseComplex(mesh), costs).tracks, angles, costs);
    PruneOptions options;
    options.eta = -1e9;
    options.maxTurn = 89;
    const PruneResult none = pruneLayout({mesh, {}, angles, costs}, layout, options);
    EXPECT_EQ(none.layout.segments.size(), 6U);
    EXPECT_EQ(none.keptNotSmooth, layout.tracks.size());
    options.maxTurn = 91;
    const PruneResult some = pruneLayout({mesh, {}, angles, costs}, layout, options);
    EXPECT_LT(some.layout.segments.size(), 6U);
    EXPECT_EQ(layoutFault(mesh, some.layout), "");
}

} // namespace
} // namespace qm::test
