#include "support/two_squares.h"

#include <gtest/gtest.h>

#include <string>

namespace qm {
namespace {

using namespace test;

TEST(ReadPly, ReadsBinaryOfEveryType) {
    for (const bool little : {true, false})
        for (const bool extras : {true, false}) {
            for (const std::string type :
                 {"float", "double", "float32", "float64", "char", "short", "int", "uint8", "int16"})
                expectTwoSquares(binaryPly(little, type, "int", extras), "a.ply");
            for (const std::string type :
                 {"char", "uchar", "short", "ushort", "int", "uint", "int32", "uint16"})
                expectTwoSquares(binaryPly(little, "float", type, extras), "a.ply");
        }
}

TEST(ReadPly, ReadsBinaryAfterOtherLineEnds) {
    for (const std::string end : {"\r\n", "\r"}) {
        std::string bytes = binaryPly(true, "double", "int", false);
        const std::size_t body = bytes.find("end_header\n") + 11;
        expectTwoSquares(replaced(bytes.substr(0, body), "\n", end) + bytes.substr(body), "a.ply");
    }
}

TEST(ReadPly, PassesOverOtherPropertiesInText) {
    std::string text = replaced(twoPly(), "property float z\n", "property float z\nproperty uchar red\n");
    text = replaced(text, " 0\n", " 0 255\n");
    expectTwoSquares(text, "a.ply");
}

TEST(ReadPly, TakesPropertiesByName) {
    std::string text = replaced(twoPlyHeader(), "property float x\nproperty float y\nproperty float z\n",
                                "property float z\nproperty float y\nproperty float x\n");
    text += "0 0 0\n0 0 1\n0 1 1\n0 1 0\n0 0 2\n0 1 2\n4 0 1 2 3\n4 1 4 5 2\n";
    expectTwoSquares(text, "a.ply");
}

TEST(ReadPly, RefusesBadHeaders) {
    const std::map<std::string, std::string> faults{
        {"property float y\n", "do not have one x, y and z"},
        {"property list uchar int vertex_indices\n", "do not have one list vertex_indices"},
        {"format ascii 1.0\n", "names no format"},
        {"element vertex 6\n", "before any element"},
        {"end_header\n", "has no end"},
    };
    for (const auto& [line, reason] : faults)
        EXPECT_TRUE(says(refusal(replaced(twoPlyHeader(), line, ""), "a.ply"), reason)) << line;
    EXPECT_TRUE(
        says(refusal(replaced(twoPly(), "float y", "real y"), "a.ply"), "line 6: \"real\" is no type"));
    EXPECT_TRUE(
        says(refusal(replaced(twoPly(), "ascii", "utf8"), "a.ply"), "format \"utf8\" is not understood"));
    const std::string format = "format ascii 1.0\n";
    EXPECT_TRUE(
        says(refusal(replaced(twoPly(), format, format + "format binary_little_endian 1.0\n"), "a.ply"),
             "names a format twice"));
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "vertex 6", "vertex six"), "a.ply"), "has no count"));
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "vertex 6", "vertex -6"), "a.ply"), "has no count"));
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "list uchar", "list float"), "a.ply"), "length of a list"));
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "float z\n", "float z\nproperty float x\n"), "a.ply"),
                     "one x, y and z"));
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "element face", "element vertex"), "a.ply"), "occurs twice"));
    EXPECT_TRUE(says(refusal("OFF\n", "a.ply"), "does not begin with ply"));
}

TEST(ReadPly, TakesLinearTimeForManyElements) {
    std::string header = "ply\nformat ascii 1.0\n";
    for (int k = 0; k < 1'000'000; ++k) // in quadratic time, a quarter of an hour
        header += "element e" + std::to_string(k) + " 0\n";
    EXPECT_TRUE(says(refusal(header + "end_header\n", "a.ply"), "holds no faces"));
}

TEST(ReadPly, RefusesWhatWasCutOff) {
    for (const std::string& whole :
         {twoPly().substr(0, twoPly().size() - 1), binaryPly(true, "float", "int", false),
          binaryPly(false, "double", "ushort", true)})
        for (std::size_t size = 1; size < whole.size(); ++size)
            EXPECT_FALSE(refusal(whole.substr(0, size), "a.ply").empty()) << size;
    EXPECT_TRUE(says(refusal(twoPly().substr(0, twoPly().size() - 4), "a.ply"),
                     "face 1 (line 18): the file ends there, its header announces 2"));
}

TEST(ReadPly, RefusesMoreThanItsHeaderSays) {
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "face 2", "face 1"), "a.ply"), "^line 18: the file goes on"));
    EXPECT_TRUE(says(refusal(binaryPly(true, "float", "int", false) + "x", "a.ply"), "the file goes on"));
    expectTwoSquares(binaryPly(true, "float", "int", false) + "\n", "a.ply");
}

TEST(ReadPly, RefusesBadIndicesAndLengths) {
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "4 1 4 5 2", "4 1 4 5 2.5"), "a.ply"),
                     "face 1 (line 18): a vertex index is no whole number"));
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "4 1 4 5 2", "4 1 4 5 nan"), "a.ply"), "no whole number"));
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "4 1 4 5 2", "4 1 4 5 1e300"), "a.ply"), "out of range"));
    EXPECT_TRUE(
        says(refusal(replaced(twoPly(), "4 1 4 5 2", "4 1 4 5 -1"), "a.ply"), "index -1 is out of range"));
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "4 1 4 5 2", "-4 1 4 5 2"), "a.ply"), "impossible length"));
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "4 1 4 5 2", "1e18 1 4 5 2"), "a.ply"), "impossible length"));
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "4 1 4 5 2", "4 1 four 5 2"), "a.ply"),
                     "line 18: \"four\" is no number"));
}

TEST(ReadPly, AllocatesNothingForAHostileHeader) {
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "vertex 6", "vertex 9000000000000000000"), "a.ply"),
                     "header announces"));
    EXPECT_TRUE(
        says(refusal(replaced(binaryPly(true, "float", "int", false), "face 2", "face 9000000000000000000"),
                     "a.ply"),
             "face 2: the file ends there"));
}

} // namespace
} // namespace qm
