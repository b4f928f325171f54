/// \file What plane patches demand of their control points.
#include "bspline/fitting/planes/plane_demands.h"

#include <gtest/gtest.h>

namespace qm {
namespace {

/// Three control points along u and two along v, in the plane z = 0.
Patch flatPatch() {
    Patch patch;
    patch.count = {3, 2};
    patch.controlPoints = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    return patch;
}

TEST(PlaneDemands, AreThoseOfAllPointsAndOfStraightSides) {
    FlatPatch flat{{{0, 0, 1}, 0}, {}};
    EXPECT_EQ(demandsOf(flatPatch(), flat, 10).size(), 6U);
    flat.outlines[0] = Plane{{0, 1, 0}, 0};
    const auto demands = demandsOf(flatPatch(), flat, 10);
    ASSERT_EQ(demands.size(), 9U);
    EXPECT_EQ(demands[6].unknown, 10U);
    EXPECT_EQ(demands[8].unknown, 12U);
    EXPECT_EQ(demands[8].plane.normal, Point(0, 1, 0));
}

TEST(PlaneDemands, AreMetUpToADistance) {
    FlatPatch flat{{{0, 0, 1}, 0}, {}};
    Patch patch = flatPatch();
    EXPECT_TRUE(isFlat(patch, flat, 0));
    patch.controlPoints[4][2] = -0.1;
    EXPECT_FALSE(isFlat(patch, flat, 0.09));
    EXPECT_TRUE(isFlat(patch, flat, 0.11));
    flat.outlines[2] = Plane{{0, 1, 0}, 1.5};
    EXPECT_FALSE(isFlat(patch, flat, 0.11)) << "the side is straight, but elsewhere";
}

} // namespace
} // namespace qm
