#include "support/two_squares.h"

#include <gtest/gtest.h>

#include <string>

namespace qm {
namespace {

using namespace test;

TEST(ReadOff, UnderstandsTheKindsOfHeader) {
    for (const std::string header :
         {"OFF 6 2 7\n", "OFF\n\n# c\n6 2 7 # c\n", "OFF\n6 2\n", "6 2 7\n", "OFF\n6\n2\n7\n",
          "COFF\n6 2 0\n", "NOFF\n6 2 0\n", "STCNOFF 6 2 0\n", "OFF 6\n2 7\n"})
        expectTwoSquares(replaced(twoOff(), "OFF\n6 2 7\n", header), "a.off");
}

TEST(ReadOff, PassesOverColours) {
    expectTwoSquares(replaced(twoOff(), " 0\n", " 0 255 0 0 255\n"), "a.off");
    expectTwoSquares(replaced(replaced(twoOff(), "2 3\n", "2 3 0.5 0.5 0.5\n"), "5 2\n", "5 2 7\n"), "a.off");
}

TEST(ReadOff, AllowsElementsSpreadOverLines) {
    const std::string body = twoOff().substr(twoOff().find("0 0 0"));
    expectTwoSquares("OFF\n6 2 7\n" + replaced(body, " ", "\n"), "a.off");
    expectTwoSquares("OFF\n6 2 7\n" + replaced(body, " ", "\n\n# comment\n"), "a.off");
}

TEST(ReadOff, AllowsAFileWithoutLines) {
    expectTwoSquares(replaced(twoOff(), "\n", " "), "a.off");
}

TEST(ReadOff, RefusesOtherKinds) {
    EXPECT_TRUE(says(refusal("OFF BINARY\n", "a.off"), "binary OFF"));
    EXPECT_TRUE(says(refusal("4OFF\n1 1 1\n", "a.off"), "three dimensions"));
    EXPECT_TRUE(says(refusal("nOFF\n3\n1 1 1\n", "a.off"), "three dimensions"));
    EXPECT_TRUE(says(refusal("v 0 0 0\n", "a.off"), "does not begin with OFF"));
    EXPECT_TRUE(says(refusal("OFF\n6 x 7\n", "a.off"), "line 2: the number of faces is missing"));
    EXPECT_TRUE(says(refusal("OFF\n-6 2 7\n", "a.off"), "number of vertices is missing"));
    EXPECT_TRUE(says(refusal("OFF\n", "a.off"), "number of vertices is missing"));
}

TEST(ReadOff, RefusesWhatWasCutOff) {
    for (std::size_t size = twoOff().size() - 2; size > 12; --size)
        EXPECT_FALSE(refusal(twoOff().substr(0, size), "a.off").empty());
    EXPECT_TRUE(
        says(refusal(twoOff().substr(0, 30), "a.off"), "the file ends after 3 vertices, its header says 6"));
    EXPECT_TRUE(says(refusal(twoOff().substr(0, twoOff().size() - 10), "a.off"),
                     "the file ends after 1 face, its header says 2"));
}

TEST(ReadOff, RefusesMoreThanItsHeaderSays) {
    EXPECT_TRUE(says(refusal(replaced(twoOff(), "6 2 7", "6 1 7"), "a.off"),
                     "^line 10: the file goes on after the 1 face that"));
}

TEST(ReadOff, AllocatesNothingForAHostileHeader) {
    for (const std::string count : {"1000000000000", "9223372036854775807", "99999999999999999999999"}) {
        EXPECT_TRUE(says(refusal("OFF\n" + count + " 1 0\n0 0 0\n", "a.off"), "file ends after 1 vertex,"));
        EXPECT_TRUE(says(refusal("OFF\n1 " + count + " 0\n0 0 0\n", "a.off"), "file ends after 0 faces"));
        EXPECT_TRUE(says(refusal("OFF\n1 1 0\n0 0 0\n" + count + " 1 1 1 1\n", "a.off"),
                         "cannot have that many vertices"));
    }
}

TEST(ReadOff, TakesNoHugeIndexForAnother) {
    EXPECT_TRUE(says(refusal(replaced(twoOff(), "1 4 5 2", "1 4 5 99999999999999999999999"), "a.off"),
                     "is out of range"));
    EXPECT_TRUE(says(refusal(replaced(twoOff(), "1 4 5 2", "1 4 5 4294967298"), "a.off"), "is out of range"));
    EXPECT_TRUE(says(refusal(replaced(twoOff(), "1 4 5 2", "1 4 5 2.0"), "a.off"), "is no whole number"));
}

TEST(ReadOff, SaysThatIndicesSeemToCountFromOne) {
    EXPECT_TRUE(says(
        refusal(replaced(replaced(twoOff(), "4 0 1 2 3", "4 1 2 3 4"), "4 1 4 5 2", "4 2 5 6 3"), "a.off"),
        "^face 1 (line 10): vertex index 6 is out of range", "count from 1"));
}

} // namespace
} // namespace qm
