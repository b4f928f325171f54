#include "prune/prune.h"

#include <gtest/gtest.h>

namespace qm::test {
namespace {

FrontPoint point(std::size_t segments, double cost, double sharpness) {
    FrontPoint made;
    made.segments = segments;
    made.cost = cost;
    made.capturedSharpness = sharpness;
    return made;
}

TEST(PruningFront, KeepsWhatIsBetterInAnything) {
    std::vector<FrontPoint> front;
    addToFront(front, point(10, 5, 0.5));
    addToFront(front, point(9, 6, 0.5));
    addToFront(front, point(10, 4, 0.4));
    addToFront(front, point(11, 6, 0.6));
    EXPECT_EQ(front.size(), 4U);
}

TEST(PruningFront, LeavesOutWhatIsNoBetter) {
    std::vector<FrontPoint> front{point(10, 5, 0.5)};
    for (const FrontPoint& worse : {point(10, 5, 0.5), point(11, 5, 0.5), point(10, 6, 0.5),
                                    point(10, 5, 0.4), point(10, 5 - 1e-12, 0.5 + 1e-12)})
        addToFront(front, worse);
    ASSERT_EQ(front.size(), 1U);
    EXPECT_EQ(front[0].cost, 5);
}

TEST(PruningFront, TakesThePlaceOfAllThatItIsAsGoodAs) {
    std::vector<FrontPoint> front{point(12, 5, 0.5), point(11, 6, 0.5), point(9, 7, 0.5)};
    addToFront(front, point(10, 5, 0.5));
    ASSERT_EQ(front.size(), 2U);
    EXPECT_EQ(front[0].segments, 9U);
    EXPECT_EQ(front[1].segments, 10U);
}

} // namespace
} // namespace qm::test
