/// \file Points that equations keep equal.
#include "bspline/fitting/planes/tied_points.h"

#include <gtest/gtest.h>

#include <vector>

namespace qm {
namespace {

TEST(TiedPoints, AreOnePointInAllOtherEquations) {
    const std::vector<LinearForm> equations{
        {{1, 3}, {1, -1}}, {{3, 4}, {-2, 2}}, {{0, 1, 4}, {1, 2, 3}}, {{2, 3}, {1, 1}}};
    const TiedPoints tied = tiedPoints(5, equations);
    EXPECT_EQ(tied.setOf, (std::vector<std::size_t>{0, 1, 2, 1, 1}));
    EXPECT_EQ(tied.sizes, (std::vector<double>{1, 3, 1}));
    ASSERT_EQ(tied.equations.size(), 2U);
    EXPECT_EQ(tied.equations[0].unknowns, (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(tied.equations[0].weights, (std::vector<double>{1, 5}));
    EXPECT_EQ(tied.equations[1].unknowns, (std::vector<std::size_t>{2, 1})) << "x + y = 0 ties nothing";
}

} // namespace
} // namespace qm
