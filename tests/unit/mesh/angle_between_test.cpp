/// \file Angles between vectors.
#include "mesh/angle_between.h"

#include <gtest/gtest.h>

namespace {

using qm::Point;

TEST(AngleBetween, IsPreciseNearZeroAndHalfATurn) {
    EXPECT_NEAR(qm::degreesBetween({0, 0, 1}, {0, 1, 0}), 90, 1e-12);
    EXPECT_NEAR(qm::angleBetween({1, 0, 0}, {3, 3e-9, 0}), 1e-9, 1e-20);
    EXPECT_NEAR(qm::angleBetween({1, 0, 0}, {-3, 3e-9, 0}), std::numbers::pi - 1e-9, 1e-15);
}

TEST(AngleBetween, IsZeroBesideNoVectorWhateverTheSigns) {
    for (const double sign : {1, -1})
        EXPECT_EQ(qm::angleBetween({0, 0, 0}, {sign, sign, sign}), 0);
}

} // namespace
