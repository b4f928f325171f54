#include "bspline/fitting/energy/thin_plate.h"

#include <gtest/gtest.h>

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

TEST(ThinPlate, BendsAlikeInBothDirectionsOfASquare) {
    const auto plates = thinPlates(rectangles(2, 2), 0.4);
    ASSERT_EQ(plates.size(), 6U);
    EXPECT_NEAR(plates[5].uu, 0.1 * 0.04, 1e-12);
    EXPECT_EQ(plates[5].uu, plates[5].vv);
    EXPECT_EQ(plates[5].uv, 2 * plates[5].uu);
}

TEST(ThinPlate, IsStifferAcrossNarrowQuads) {
    const ThinPlate narrow = thinPlates(rectangles(1, 3), 0.4).front();
    const double weight = narrow.uv / 2;
    EXPECT_NEAR(narrow.uu, 9 * weight, 1e-12);
    EXPECT_NEAR(narrow.vv, weight / 9, 1e-12);
    const ThinPlate wide = thinPlates(rectangles(3, 1), 0.4).front();
    EXPECT_NEAR(wide.vv, narrow.uu, 1e-12);
}

TEST(ThinPlate, DependsOnTheToleranceInQuadsAlone) {
    const ThinPlate small = thinPlates(rectangles(0.01, 0.02), 0.001).front();
    const ThinPlate large = thinPlates(rectangles(100, 200), 10).front();
    EXPECT_NEAR(small.uu, large.uu, 1e-12);
    EXPECT_NEAR(small.uv, large.uv, 1e-12);
}

TEST(ThinPlate, IsSoftWithoutArea) {
    const ThinPlate soft = softPlates({2, 3}).front();
    const ThinPlate flat = thinPlates(rectangles(0, 1), 0.1).front();
    EXPECT_EQ(flat.uu, soft.uu);
    EXPECT_EQ(flat.uv, soft.uv);
    EXPECT_LT(soft.uu, thinPlates(rectangles(1, 1), 0.1).front().uu);
}

} // namespace
} // namespace qm
