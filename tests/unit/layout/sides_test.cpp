#include "layout/sides.h"

#include <gtest/gtest.h>

namespace qm {
namespace {

TEST(Sides, FollowOneAnotherCounterClockwise) {
    constexpr std::array<int, 2> size{3, 2};
    EXPECT_EQ(placeOnSide(size, 0, 0), (std::array{0, 0}));
    EXPECT_EQ(placeOnSide(size, 1, 0), (std::array{3, 0}));
    EXPECT_EQ(placeOnSide(size, 2, 0), (std::array{3, 2}));
    EXPECT_EQ(placeOnSide(size, 3, 0), (std::array{0, 2}));
    for (int side = 0; side < 4; ++side) {
        EXPECT_EQ(placeOnSide(size, side, size[directionAlong(side)]), placeOnSide(size, (side + 1) % 4, 0));
        EXPECT_EQ(sideAcross(directionAcross(side), isFarSide(side)), side);
    }
}

TEST(Sides, PointsAreNumberedInTheOrderOfTheParameters) {
    constexpr std::array<std::size_t, 2> count{4, 3};
    for (int side = 0; side < 4; ++side) {
        const std::size_t last = count[directionAlong(side)] - 1;
        for (std::size_t k = 0; k <= last; ++k) {
            const auto [column, row] = placeOnSide<std::size_t>({3, 2}, side, k);
            EXPECT_EQ(pointOnSide(count, side, alongSide(side, k, last)), row * count[0] + column);
        }
    }
    EXPECT_EQ(pointOnSide(count, 1, 2, 1), 10U) << "one column away from the last";
}

} // namespace
} // namespace qm
