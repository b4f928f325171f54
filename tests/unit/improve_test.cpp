#include "merge/improve.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace qm {
namespace {

TEST(BoundBelow, TakesRoundingForWhatItIs) {
    EXPECT_EQ(boundBelow(-3, 5), -3);
    EXPECT_EQ(boundBelow(5 + 1e-9, 5), 5);
    EXPECT_EQ(boundBelow(-1e5 + 1e-3, -1e5), -1e5);
}

TEST(BoundBelow, IsAFaultWhereAGraphIsCheaper) {
    EXPECT_THROW((void)boundBelow(208.46, 205.11), std::logic_error);
    EXPECT_THROW((void)boundBelow(5.001, 5), std::logic_error);
    EXPECT_THROW((void)boundBelow(1e50, 5), std::logic_error);
}

} // namespace
} // namespace qm
