/// \file Lists of texts as one text.
#include "base/joined.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

TEST(Joined, PutsTheSeparatorBetweenTexts) {
    EXPECT_EQ(qm::joined(std::vector<std::string>{}), "");
    EXPECT_EQ(qm::joined(std::vector<std::string>{""}), "");
    EXPECT_EQ(qm::joined(std::vector{"one", "two"}), "one, two");
    EXPECT_EQ(qm::joined(std::vector{"", "", "three"}, "; "), "; ; three");
}

} // namespace
