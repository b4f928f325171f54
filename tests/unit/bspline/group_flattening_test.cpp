/// \file Moving the plane patches of a group into their planes.
#include "bspline/fitting/planes/group_flattening.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {
namespace {

using Planes = std::vector<std::optional<FlatPatch>>;

/// Patches of one control point each, all at a height of 0.
struct Group {
    explicit Group(std::size_t size) : patches(size), planes(size) {
        group.unknowns = size;
        for (std::size_t k = 0; k < size; ++k) {
            group.patches.push_back(k);
            patches[k].count = {1, 1};
            patches[k].controlPoints = {Point(1, 0, 0)};
        }
    }

    /// Lets two patches share a border, and ties their points to one another.
    void tie(std::size_t one, std::size_t other, double ratio = 1) {
        group.neighbours.push_back({one, other});
        group.equations.push_back({{one, other}, {1, -ratio}});
    }

    void demand(std::size_t patch, double height) { planes[patch] = FlatPatch{{{0, 0, 1}, height}, {}}; }

    bool flatten() { return flattenGroup(group, planes, patches); }

    [[nodiscard]] double height(std::size_t patch) const { return patches[patch].controlPoints[0][2]; }

    MovingGroup group;
    std::vector<Patch> patches;
    Planes planes;
};

TEST(GroupFlattening, MovesPatchesIntoTheirPlanesAndTakesNeighboursAlong) {
    Group three(3);
    three.tie(0, 1);
    three.demand(0, 2);
    EXPECT_TRUE(three.flatten());
    EXPECT_NEAR(three.height(0), 2, 1e-12);
    EXPECT_NEAR(three.height(1), 2, 1e-12);
    EXPECT_EQ(three.height(2), 0);
}

TEST(GroupFlattening, TellsThatNothingHadToMove) {
    Group one(1);
    one.demand(0, 0);
    EXPECT_FALSE(one.flatten());
    EXPECT_TRUE(one.planes[0].has_value());
}

TEST(GroupFlattening, GivesUpManyContradictionsOfAllSizes) {
    // More than there are attempts, each half as large as the one before.
    constexpr std::size_t pairs = 20;
    Group group(2 * pairs + 1);
    double height = 1;
    for (std::size_t k = 0; k < pairs; ++k, height /= 2) {
        group.tie(2 * k, 2 * k + 1);
        group.demand(2 * k, height);
        group.demand(2 * k + 1, -height);
    }
    group.demand(2 * pairs, 1);
    EXPECT_TRUE(group.flatten());
    EXPECT_NEAR(group.height(2 * pairs), 1, 1e-12);
    for (std::size_t k = 0; k < 2 * pairs; ++k)
        EXPECT_FALSE(group.planes[k].has_value()) << k;
}

TEST(GroupFlattening, GivesUpOnlyWhatPushesAPatchTooFar) {
    // The patch in the middle would move a hundred times as far as the plane is away.
    Group group(5);
    group.tie(1, 0, 100);
    group.demand(0, 1);
    group.tie(3, 4, 0.5);
    group.demand(4, 1);
    group.demand(2, 1);
    EXPECT_TRUE(group.flatten());
    EXPECT_FALSE(group.planes[0].has_value());
    EXPECT_EQ(group.height(1), 0);
    EXPECT_NEAR(group.height(2), 1, 1e-12);
    EXPECT_NEAR(group.height(3), 0.5, 1e-12);
    EXPECT_NEAR(group.height(4), 1, 1e-12);
}

} // namespace
} // namespace qm
