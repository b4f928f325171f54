#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/knots/reach_alignment.h"
#include "bspline/fitting/knots/uneven_lines.h"
#include "bspline/fitting/system/continuity_equations.h"
#include "support/grid_layout.h"
#include "support/network_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace qm {
namespace {

using test::Grid;
using test::networkOf;

TEST(KnotPlan, ForcesDoubleKnotsWhereSmoothBordersTurnIntoCreases) {
    // A crease along j = 3 for i < 4, which then ends.
    const Grid grid{
        8, 6, [](double i, double j) { return Point(i, j, std::max(0.0, 4 - i) * 0.4 * std::abs(j - 3)); }};
    const QuadMesh mesh = test::makeMesh(grid);
    const Layout layout = test::makeLayout(grid, {{0, 0, 8, 3}, {0, 3, 8, 6}});
    const SmoothNetwork network = networkOf(mesh, layout);
    ASSERT_EQ(network.runs.size(), 1U);
    KnotPlan plan(layout, network);
    for (const PatchSpace& space : plan.spaces()) {
        const auto inner = space.knots[0].size() - 8 + space.knots[1].size() - 8;
        EXPECT_EQ(inner, 2U) << "one knot, twice";
    }
    EXPECT_TRUE(plan.insert(0, 1, 1));
    EXPECT_FALSE(plan.insert(0, 1, 1));
    EXPECT_FALSE(plan.insert(0, 1, 3)) << "its end";
    plan.erase(0, 1, 1);
    EXPECT_TRUE(plan.chosen(0, 1).empty());
}

TEST(KnotPlan, HasIntervalsOfALengthAtLeast) {
    ReferenceGrid grid{.size = {2, 3}, .steps = 2};
    for (int j = 0; j <= 6; ++j)
        for (int i = 0; i <= 4; ++i)
            grid.points.emplace_back(0.1 * i, 2.0 * j, 0); // edges of length 0.2 and 4
    const IntervalLengths lengths = partsOfEdges({grid}, 0.6);
    EXPECT_NEAR(lengths[0][0], 3, 1e-12);
    EXPECT_NEAR(lengths[0][1], 0.15, 1e-12);
    EXPECT_EQ(partsOfEdges({grid}, 0)[0][0], 0);
    const Grid sheet{8, 6, [](double i, double j) { return Point(i, j, 0); }};
    const QuadMesh mesh = test::makeMesh(sheet);
    const Layout layout = test::makeLayout(sheet, {{0, 0, 8, 6}});
    const SmoothNetwork network = networkOf(mesh, layout);
    KnotPlan plan(layout, network, lengths);
    EXPECT_NEAR(plan.minInterval(0, 0), 6, 1e-12);
    EXPECT_NEAR(plan.minInterval(0, 1), 0.3, 1e-12);
    EXPECT_TRUE(plan.allow(MinInterval::eighth));
    EXPECT_NEAR(plan.minInterval(0, 0), 3, 1e-12);
    EXPECT_NEAR(plan.minInterval(0, 1), 0.15, 1e-12);
    EXPECT_FALSE(plan.allow(MinInterval::eighth)) << "again";
    EXPECT_TRUE(plan.allow(MinInterval::thirtySecond));
    EXPECT_NEAR(plan.minInterval(0, 1), 0.15, 1e-12) << "as short as the length, not shorter";
    EXPECT_FALSE(plan.allow(MinInterval::quarter)) << "longer";
    KnotPlan unlimited(layout, network);
    EXPECT_EQ(unlimited.minInterval(0, 0), 0.25);
    EXPECT_TRUE(unlimited.allow(MinInterval::thirtySecond));
    EXPECT_EQ(unlimited.minInterval(0, 0), 0.03125);
}

TEST(KnotPlan, HasTheDoubleKnotsThatItIsGiven) {
    const Grid sheet{8, 6, [](double i, double j) { return Point(i, j, 0); }};
    const QuadMesh mesh = test::makeMesh(sheet);
    const Layout layout = test::makeLayout(sheet, {{0, 0, 8, 6}});
    const SmoothNetwork network = networkOf(mesh, layout);
    KnotPlan plan(layout, network, {}, {{{{2, 7}, {}}}});
    plan.insert(0, 0, 2);
    plan.insert(0, 1, 3);
    const std::vector<PatchSpace> spaces = plan.spaces();
    EXPECT_EQ(spaces[0].knots[0], (std::vector<double>{0, 0, 0, 0, 2, 2, 7, 7, 8, 8, 8, 8}));
    EXPECT_EQ(spaces[0].knots[1], (std::vector<double>{0, 0, 0, 0, 3, 6, 6, 6, 6}));
}

TEST(UnevenLines, LieBetweenNarrowQuadsAndMuchWiderOnes) {
    const std::vector<double> columns{0, 1, 2, 8, 12, 12.7};
    ReferenceGrid grid{.size = {5, 2}, .steps = 2};
    for (int j = 0; j <= 4; ++j)
        for (std::size_t i = 0; i <= 10; ++i)
            grid.points.emplace_back((columns[i / 2] + columns[(i + 1) / 2]) / 2, 0.5 * j, 0);
    const KnotLists lines = unevenLines({grid});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0][0], (std::vector<double>{2, 4})) << "at 3 the widths are 6 and 4";
    EXPECT_TRUE(lines[0][1].empty());
}

/// Three patches of 12 x 2 quads in a column, each the neighbour of the next, with tangent ratios at the
/// beginnings of both borders.
class TwoBorders : public testing::Test {
protected:
    TwoBorders()
        : sheet{12, 6, [](double i, double j) { return Point(i, j, 0); }}, mesh(test::makeMesh(sheet)),
          layout(test::makeLayout(sheet, {{0, 0, 12, 2}, {0, 2, 12, 4}, {0, 4, 12, 6}})),
          network(networkOf(mesh, layout)) {
        for (SmoothRun& run : network.runs)
            run.ratio.atEnd[endAtZero(run)] = 0.5;
    }

    /// Of a run's two ends, the one at u = 0.
    [[nodiscard]] std::size_t endAtZero(const SmoothRun& run) const {
        return parameter(run, run.begin) == 0 ? 0 : 1;
    }
    [[nodiscard]] double parameter(const SmoothRun& run, double x) const {
        const StretchSide& side = network.stretches[run.stretch].sides[0];
        return patchParameter(layout.segments[side.patch].size, side, x);
    }

    /// The reaches of both ratios, if those that end at these knots of the outer patches are aligned.
    [[nodiscard]] std::array<double, 2> aligned(double first, double second) {
        KnotPlan plan(layout, network);
        plan.insert(0, 0, first);
        plan.insert(2, 0, second);
        plan.endAtFirstKnots();
        const std::size_t before = unknownsOf(plan.spaces());
        alignReaches(plan);
        saved = before - unknownsOf(plan.spaces());
        const SmoothRun& a = plan.runs()[0];
        const SmoothRun& b = plan.runs()[1];
        return {a.ratio.reach[endAtZero(a)], b.ratio.reach[endAtZero(b)]};
    }

    Grid sheet;
    QuadMesh mesh;
    Layout layout;
    SmoothNetwork network;
    std::size_t saved = 0; ///< control points, the last time
};

TEST_F(TwoBorders, EndTheirRatiosAtOneKnotOfThePatchBetween) {
    ASSERT_EQ(network.runs.size(), 2U);
    const auto reaches = aligned(4, 6);
    EXPECT_EQ(reaches[0], reaches[1]);
    EXPECT_TRUE(reaches[0] == 4 || reaches[0] == 6);
    EXPECT_EQ(saved, 4U) << "two rows of the patch between, less one more of an outer patch";
}

TEST_F(TwoBorders, KeepReachesThatAreAlikeAlready) {
    EXPECT_EQ(aligned(4, 4), (std::array<double, 2>{4, 4}));
    EXPECT_EQ(saved, 0U);
}

TEST_F(TwoBorders, KeepReachesThatAreFarFromEachOther) {
    EXPECT_EQ(aligned(1, 6), (std::array<double, 2>{1, 6}));
    EXPECT_EQ(aligned(2, 6), (std::array<double, 2>{2, 2})) << "a third";
}

TEST_F(TwoBorders, CountWhatOthersNeedThere) {
    network.runs[1].ratio.atEnd[endAtZero(network.runs[1])] = 0;
    EXPECT_EQ(aligned(4, 6)[0], 4) << "nothing else ends at 6";
    EXPECT_EQ(saved, 0U);
}

} // namespace
} // namespace qm
