/// \file Joining sets, and taking them apart again.
#include "base/disjoint_sets.h"

#include <gtest/gtest.h>

namespace qm {
namespace {

TEST(DisjointSets, TheLowestMemberStandsForItsSet) {
    DisjointSets sets(6);
    sets.join(5, 3);
    sets.join(3, 1);
    sets.join(4, 2);
    EXPECT_EQ(sets.find(5), 1U);
    EXPECT_EQ(sets.find(4), 2U);
    EXPECT_EQ(sets.find(0), 0U);
    EXPECT_EQ(sets.members(), (std::vector<std::vector<std::size_t>>{{0}, {1, 3, 5}, {2, 4}}));
    sets.join(2, 5);
    for (std::size_t k = 1; k < 6; ++k)
        EXPECT_EQ(sets.find(k), 1U);
}

TEST(DisjointSets, SetsWhoseMembersAreAllIsolatedCanBeJoinedAnew) {
    DisjointSets sets(4);
    sets.join(0, 1);
    sets.join(2, 3);
    sets.isolate(2);
    sets.isolate(3);
    EXPECT_EQ(sets.find(2), 2U);
    EXPECT_EQ(sets.find(3), 3U);
    sets.join(3, 0);
    EXPECT_EQ(sets.find(3), 0U);
    EXPECT_EQ(sets.find(1), 0U);
    EXPECT_EQ(sets.find(2), 2U);
}

} // namespace
} // namespace qm
