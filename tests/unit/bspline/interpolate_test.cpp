#include "base/at.h"
#include "bspline/splines/evaluate.h"
#include "bspline/splines/interpolate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace qm {
namespace {

std::vector<Point> wavyGrid(int m, int n) {
    std::vector<Point> grid;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= m; ++i)
            grid.emplace_back(i + 0.2 * std::sin(3.0 * j), j + 0.1 * std::cos(i * j),
                              std::sin(0.7 * i + 0.3 * j * j));
    return grid;
}

class InterpolateSizes : public testing::TestWithParam<std::array<int, 2>> {};

TEST_P(InterpolateSizes, HasTheCountsAndKnotsOfTheMethod) {
    const auto [m, n] = GetParam();
    const Patch patch = interpolate(wavyGrid(m, n), {m, n});
    EXPECT_EQ(patch.count, (std::array{m + 3, n + 3}));
    EXPECT_EQ(patch.controlPoints.size(), static_cast<std::size_t>((m + 3) * (n + 3)));
    ASSERT_EQ(patch.knots[0].size(), static_cast<std::size_t>(m + 7));
    ASSERT_EQ(patch.knots[1].size(), static_cast<std::size_t>(n + 7));
    EXPECT_EQ(patch.knots[0].front(), -3);
    EXPECT_EQ(patch.knots[0].back(), m + 3);
    EXPECT_EQ(domain(patch)[1][0], 0);
    EXPECT_EQ(domain(patch)[1][1], n);
}

TEST_P(InterpolateSizes, PassesThroughEveryPoint) {
    const auto [m, n] = GetParam();
    const auto grid = wavyGrid(m, n);
    const Patch patch = interpolate(grid, {m, n});
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= m; ++i) {
            const Point expected = grid[at(j * (m + 1) + i)];
            EXPECT_LT((evaluate(patch, i, j).position - expected).norm(), 1e-12) << i << ' ' << j;
        }
}

TEST_P(InterpolateSizes, SolvesTheSystemOfTheMethod) {
    const auto [m, n] = GetParam();
    const auto grid = wavyGrid(m, n);
    const Patch patch = interpolate(grid, {m, n});
    const int width = m + 3;
    const auto control = [&](int i, int j) { return patch.controlPoints[at(j * width + i)]; };
    for (int i = 0; i < width; ++i) {
        EXPECT_EQ(control(i, 0), control(i, 1));
        EXPECT_EQ(control(i, n + 1), control(i, n + 2));
    }
    for (int j = 0; j < n + 3; ++j) {
        EXPECT_LT((control(0, j) - control(1, j)).norm(), 1e-12);
        EXPECT_LT((control(m + 1, j) - control(m + 2, j)).norm(), 1e-12);
    }
    // The rows of the first stage, recovered from the columns of the second, satisfy 1 4 1 = 6 P.
    const auto row = [&](int i, int j) {
        return (control(i, j) + 4.0 * control(i, j + 1) + control(i, j + 2)) / 6.0;
    };
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= m; ++i) {
            const Point sum = row(i, j) + 4.0 * row(i + 1, j) + row(i + 2, j);
            EXPECT_LT((sum - 6.0 * grid[at(j * (m + 1) + i)]).norm(), 1e-11);
        }
}

INSTANTIATE_TEST_SUITE_P(Sizes, InterpolateSizes,
                         testing::Values(std::array{1, 1}, std::array{1, 2}, std::array{2, 1},
                                         std::array{1, 17}, std::array{3, 3}, std::array{13, 4},
                                         std::array{40, 31}));

TEST(Interpolate, IsTheControlPointsOfTheSmallestCaseByHand) {
    // m = n = 1: 5 C1 + C2 = 6 P0 and C1 + 5 C2 = 6 P1 in each direction.
    const std::vector<Point> grid = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 4}};
    const Patch patch = interpolate(grid, {1, 1});
    // One direction maps (p0, p1) to ((5 p0 - p1) / 4, (5 p1 - p0) / 4).
    EXPECT_LT((patch.controlPoints[0] - Point(-1, -1, 0.25)).norm(), 1e-14);
    EXPECT_LT((patch.controlPoints[2] - Point(5, -1, -1.25)).norm(), 1e-14);
    EXPECT_LT((patch.controlPoints[15] - Point(5, 5, 6.25)).norm(), 1e-14);
}

TEST(Interpolate, IsTwiceContinuouslyDifferentiable) {
    const Patch patch = interpolate(wavyGrid(6, 5), {6, 5});
    const double h = 1e-5;
    for (int i = 1; i < 6; ++i) {
        const SurfacePoint before = evaluate(patch, i - h, 2.3);
        const SurfacePoint at = evaluate(patch, i, 2.3);
        const SurfacePoint after = evaluate(patch, i + h, 2.3);
        EXPECT_LT((after.du - 2.0 * at.du + before.du).norm() / h, 1e-3)
            << "second derivative jumps at " << i;
    }
}

} // namespace
} // namespace qm
