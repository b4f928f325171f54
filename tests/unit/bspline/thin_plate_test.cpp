#include "bspline/fitting/energy/thin_plate.h"

#include <gtest/gtest.h>

#include <vector>

namespace qm {
namespace {

/// A grid of equal rectangles.
ReferenceGrid rectangles(double u, double v) {
    ReferenceGrid grid;
    grid.size = {2, 3};
    grid.steps = 2;
    for (int j = 0; j <= 6; ++j)
        for (int i = 0; i <= 4; ++i)
            grid.points.emplace_back(u * i / 2, v * j / 2, 0);
    return grid;
}

/// Of plates that are not stiff.
std::vector<ThinPlate> platesOf(const ReferenceGrid& grid, double tolerance) {
    return thinPlates(grid, std::vector<bool>(6), tolerance);
}

TEST(ThinPlate, BendsAlikeInBothDirectionsOfASquare) {
    const auto plates = platesOf(rectangles(2, 2), 0.4);
    ASSERT_EQ(plates.size(), 6U);
    EXPECT_NEAR(plates[5].uu, 0.1 * 0.04, 1e-12);
    EXPECT_EQ(plates[5].uu, plates[5].vv);
    EXPECT_EQ(plates[5].uv, 2 * plates[5].uu);
}

TEST(ThinPlate, IsStifferAcrossNarrowQuads) {
    const ThinPlate narrow = platesOf(rectangles(1, 3), 0.4).front();
    const double weight = narrow.uv / 2;
    EXPECT_NEAR(narrow.uu, 9 * weight, 1e-12);
    EXPECT_NEAR(narrow.vv, weight / 9, 1e-12);
    const ThinPlate wide = platesOf(rectangles(3, 1), 0.4).front();
    EXPECT_NEAR(wide.vv, narrow.uu, 1e-12);
}

TEST(ThinPlate, DependsOnTheToleranceInQuadsAlone) {
    const ThinPlate small = platesOf(rectangles(0.01, 0.02), 0.001).front();
    const ThinPlate large = platesOf(rectangles(100, 200), 10).front();
    EXPECT_NEAR(small.uu, large.uu, 1e-12);
    EXPECT_NEAR(small.uv, large.uv, 1e-12);
}

TEST(ThinPlate, IsStiffWhereToldAndNotTooStiff) {
    std::vector<bool> isStiff(6);
    isStiff[4] = true;
    for (const double tolerance : {0.4, 40.0}) { // usual weights and the largest ones
        const auto plates = thinPlates(rectangles(2, 2), isStiff, tolerance);
        EXPECT_NEAR(plates[4].uv, 3 * plates[3].uv, 1e-12);
    }
    const auto plates = thinPlates(rectangles(2, 2), isStiff, 1e-6);
    EXPECT_EQ(plates[4].uv, plates[3].uv);
}

TEST(ThinPlate, IsSoftWithoutArea) {
    const ThinPlate soft = softPlates({2, 3}).front();
    const ThinPlate flat = platesOf(rectangles(0, 1), 0.1).front();
    EXPECT_EQ(flat.uu, soft.uu);
    EXPECT_EQ(flat.uv, soft.uv);
    EXPECT_LT(soft.uu, platesOf(rectangles(1, 1), 0.1).front().uu);
}

} // namespace
} // namespace qm
