#include "bspline/fitting/first_solution.h"
#include "bspline/fitting/fit_state.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/limit/limit_surface.h"
#include "mesh/dihedral.h"
#include "support/grid_layout.h"
#include "support/network_of.h"
#include "support/quad_layout.h"
#include "support/star_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace qm {
namespace {

/// A fit to a waved sheet of two patches.
class WavedFit : public ::testing::Test {
protected:
    explicit WavedFit(double height = 0.3)
        : sheet{24, 8,
                [=](double i, double j) {
                    return Point(i, j, height * std::sin(0.03 * i * i) * std::cos(0.3 * j));
                }},
          mesh(test::makeMesh(sheet)), layout(test::makeLayout(sheet, {{0, 0, 24, 4}, {0, 4, 24, 8}})),
          network(buildNetwork(mesh, layout, dihedralAngles(mesh), 3)), reference{limitSurface(
                                                                            mesh, layout, network.sharpness(),
                                                                            4, 1)} {
        options.tolerance = 0.02;
    }

    /// The number of control points without knots that are not needed, and the number after some of them came
    /// back because the first patch was found too far away.
    struct Points {
        std::size_t first = 0;
        std::size_t removed = 0;
        std::size_t back = 0;
        bool areSomeBack = false;
    };
    [[nodiscard]] Points pointsWith(FitState::Where where) const {
        FitState state(problem, options, std::vector<bool>(2), 1);
        solveFirst(state, 2, [] { return false; });
        while (state.errors().worst() > 1 && state.refine())
            state.solveChanged(2);
        Points points{.first = state.score().controlPoints};
        state.removeKnots();
        state.solveChanged(2);
        points.removed = state.score().controlPoints;
        FitRound round = state.round();
        round.distances = {1.8, 0.5};
        state.tighten(round);
        points.areSomeBack = state.putBackKnots(where);
        state.solveChanged(2);
        points.back = state.score().controlPoints;
        return points;
    }

    test::Grid sheet;
    QuadMesh mesh;
    Layout layout;
    SmoothNetwork network;
    FitTarget reference;
    Verification verify;
    FitProblem problem{mesh, layout, network, reference, verify};
    SmoothFitOptions options;
};

TEST(FitState, BeginsAnewFromARoundWithoutChangingWhatIsFarAway) {
    constexpr std::size_t count = 160; // or all are solved for
    std::vector<test::Rectangle> strips;
    for (int k = 0; k < static_cast<int>(count); ++k)
        strips.push_back({2 * k, 0, 2 * k + 2, 6});
    const test::Grid sheet{2 * static_cast<int>(count), 6, [](double i, double j) {
                               return Point(i, j, 0.3 * std::sin(0.8 * i) * std::cos(0.5 * j));
                           }};
    const QuadMesh mesh = test::makeMesh(sheet);
    const Layout layout = test::makeLayout(sheet, strips);
    const SmoothNetwork network = buildNetwork(mesh, layout, dihedralAngles(mesh), 3);
    const FitTarget target{limitSurface(mesh, layout, network.sharpness(), 4, 1)};
    const Verification verify;
    const FitProblem problem{mesh, layout, network, target, verify};
    SmoothFitOptions options;
    options.tolerance = 0.02;
    FitState first(problem, options, std::vector<bool>(count), 1);
    solveFirst(first, 2, [] { return false; });
    while (first.errors().worst() > 1 && first.refine())
        first.solveChanged(2);
    const FitRound round = first.round();
    ASSERT_LE(first.errors().worst(), 1);

    std::vector<bool> isSoft(count);
    isSoft[0] = true;
    FitState second(problem, options, isSoft, 1);
    second.beginFrom(round, isSoft, 2);
    const std::vector<Patch> patches = second.round().patches;
    EXPECT_NE(patches[0].controlPoints, round.patches[0].controlPoints);
    EXPECT_EQ(patches[0].knots, round.patches[0].knots);
    for (std::size_t k = count * 3 / 4; k < count; ++k)
        EXPECT_EQ(patches[k].controlPoints, round.patches[k].controlPoints) << k;
    EXPECT_LT(second.errors().worst(), 1.2);
}

TEST_F(WavedFit, PutsBackTheKnotsThatTurnOutToBeNeeded) {
    using enum FitState::Where;
    const Points near = pointsWith(inCells);
    const Points inPatch = pointsWith(inPatches);
    const Points around = pointsWith(aroundPatches);
    EXPECT_TRUE(near.areSomeBack && inPatch.areSomeBack && around.areSomeBack);
    EXPECT_LT(near.removed, near.back);
    EXPECT_LT(near.back, inPatch.back) << "those far from what misses are not needed";
    EXPECT_LT(inPatch.back, around.back) << "nor those of the other patch";
    EXPECT_EQ(around.back, around.first);
}

/// Waves so high, and a tolerance so large, that patches fold with the first knots.
class HighWaves : public WavedFit {
protected:
    HighWaves() : WavedFit(6) { options.tolerance = 10; }

    /// The number of control points after the first solution.
    [[nodiscard]] std::size_t first(const std::function<bool()>& isStopRequested) const {
        FitState state(problem, options, std::vector<bool>(2), 1);
        solveFirst(state, 2, isStopRequested);
        return state.score().controlPoints;
    }
};

TEST_F(HighWaves, AreNotUnfoldedOnceTheFitIsToStop) {
    const std::size_t unfolded = first([] { return false; });
    const std::size_t stopped = first([] { return true; });
    options.unfoldings = 0;
    EXPECT_EQ(stopped, first([] { return false; }));
    EXPECT_LT(stopped, unfolded);
}

TEST(FitState, DoesNotBeginAnewTwiceWithTheSameKnots) {
    // Patches of one quad, which have no grid lines for more knots, over steep waves.
    const QuadMesh mesh = test::star(6);
    const Layout layout = test::segmentPerQuad(mesh);
    const SmoothNetwork network = test::networkOf(mesh, layout);
    FitTarget reference{limitSurface(mesh, layout, network.sharpness(), 4, 1)};
    constexpr std::array<double, 5> wave{0, 3, 0, -3, 0};
    for (ReferenceGrid& grid : reference.grids)
        for (std::size_t k = 0; k < grid.points.size(); ++k)
            grid.points[k] += Point(0, 0, wave.at(k / grid.columns()) + wave.at(k % grid.columns()));
    SmoothFitOptions options;
    options.tolerance = 0.01;
    options.unfoldings = 3;
    const Verification verify;
    FitState state({mesh, layout, network, reference, verify}, options, std::vector<bool>(6), 1);
    int times = 0;
    solveFirst(state, 1, [&] {
        ++times;
        return false;
    });
    ASSERT_TRUE(state.errors().isAnyFolded());
    EXPECT_EQ(times, 2) << "once with the same knots, and once after the last attempt";
}

} // namespace
} // namespace qm
