/// \file Ranking of layouts by the size of their surfaces.
#include "bspline/ranking.h"

#include <gtest/gtest.h>

namespace {

using qm::RankedLayout;
using qm::ranksBefore;

TEST(Ranking, WhatKeepsTheToleranceComesFirst) {
    const RankedLayout keeps{40, 0, 2000, 0.0009, true};
    const RankedLayout misses{10, 0, 500, 0.0011, false};
    EXPECT_TRUE(ranksBefore(keeps, misses));
    EXPECT_FALSE(ranksBefore(misses, keeps));
}

TEST(Ranking, FewerControlPointsCountMoreThanSegmentsAndThoseMoreThanCost) {
    const RankedLayout best{40, 5, 1000, 0.0009, true};
    EXPECT_TRUE(ranksBefore(best, {10, 0, 1001, 0.0001, true}));
    EXPECT_TRUE(ranksBefore({39, 9, 1000, 0.0009, true}, best));
    EXPECT_TRUE(ranksBefore({40, 4, 1000, 0.0009, true}, best));
    EXPECT_FALSE(ranksBefore(best, best));
}

TEST(Ranking, OfThoseThatMissItTheNearestComesFirst) {
    EXPECT_TRUE(ranksBefore({40, 0, 2000, 0.002, false}, {10, 0, 500, 0.003, false}));
}

} // namespace
