#include "base/infinity.h"
#include "mesh/files/text_lines.h"
#include "support/mesh_text.h"
#include "support/two_squares.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace qm {
namespace {

using namespace test;

TEST(ReadObj, UnderstandsTextureAndNormalIndices) {
    expectTwoSquares(replaced(twoObj(), "f 1 2 3 4\nf 2 5 6 3", "f 1/1 2/2 3/3 4/4\nf 2/2/1 5//1 6/6/6 3/"),
                     "a.obj");
}

TEST(ReadObj, UnderstandsRelativeIndices) {
    expectTwoSquares(replaced(twoObj(), "f 1 2 3 4\nf 2 5 6 3", "f -6 -5 -4 -3\nf -5/-1 -2 -1 -4"), "a.obj");
    // Negative numbers count back from the vertices before the face.
    const QuadMesh mesh =
        read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\nv 2 0 0\nv 2 1 0\nf -5 -2 -1 -4\n", "");
    EXPECT_EQ(facesOf(mesh)[1], (FaceIndices{1, 4, 5, 2}));
}

TEST(ReadObj, AllowsFacesBeforeTheirVertices) {
    expectTwoSquares("f 1 2 3 4\nf 2 5 6 3\n" + twoObj().substr(0, twoObj().find('f')), "a.obj");
}

TEST(ReadObj, PassesOverEverythingElse) {
    expectTwoSquares("mtllib x.mtl\no thing\ng a b # c\ns off\nvt 0 0\nvn 0 0 1\nvp 1\nusemtl m\nl 1 2\np 1\n"
                     "curv 0 1 1 2\nnonsense here\nV 1 2\n" +
                         twoObj() + "#f 1 2 3\n",
                     "a.obj");
}

TEST(ReadObj, PassesOverColoursAndWeights) {
    expectTwoSquares(replaced(twoObj(), " 0\n", " 0 0.5 0.5 0.5\n"), "a.obj");
    expectTwoSquares(replaced(twoObj(), " 0\n", " 0 1.0\n"), "a.obj");
}

TEST(ReadObj, JoinsContinuedLines) {
    expectTwoSquares(replaced(twoObj(), "f 1 2 3 4", "f 1 2 \\\n 3 \\\n4"), "a.obj");
    expectTwoSquares(replaced(twoObj(), "f 1 2 3 4", "f 1 2\\\r\n3 4"), "a.obj");
    expectTwoSquares(replaced(twoObj(), "v 2 0 0", "v 2 \\\n0 0"), "a.obj");
    // A comment ends with its line, even after a backslash.
    expectTwoSquares("# C:\\meshes\\\n" + twoObj(), "a.obj");
}

TEST(ReadObj, CountsLinesInMessages) {
    EXPECT_TRUE(
        says(refusal("# 1\nv 0 0\\\n 0\nv 1 x 0\n", "a.obj"), "^line 4: vertex 1: \"x\" is no number"));
    EXPECT_TRUE(says(refusal("# 1\r# 2\rv 1 x 0\r", "a.obj"), "^line 3: "));
}

TEST(ReadObj, RefusesWhatIsNoNumber) {
    for (const std::string word : {"x", "1,5", "0x1", "1.0.0", "+-1", "--1", "1e", "\x80\x1b"})
        EXPECT_TRUE(says(refusal(replaced(twoObj(), "v 2 1 0", "v 2 " + word + " 0"), "a.obj"),
                         "^line 6: vertex 5", "is no number"));
    EXPECT_TRUE(
        says(refusal(replaced(twoObj(), "v 2 1 0", "v 2 1"), "a.obj"), "fewer than three coordinates"));
    EXPECT_TRUE(
        says(refusal(replaced(twoObj(), "v 2 1 0", "v 2 " + std::string(1000, 'x')), "a.obj"), "..."));
}

TEST(ReadObj, KeepsTheSignAndTheSizeOfWhatIsOutOfRange) {
    const auto read = [](const std::string& word) { return readFileNumber<double>(word).value(); };
    EXPECT_EQ(read("1e999"), infinity);
    EXPECT_EQ(read("-1e999"), -infinity);
    EXPECT_EQ(read("-1e99999"), -infinity);
    EXPECT_EQ(read("1" + std::string(6000, '0')), infinity);
    EXPECT_EQ(read("-1" + std::string(6000, '0') + ".5"), -infinity);
    EXPECT_EQ(read("0." + std::string(6000, '0') + "1e999"), 0);
    EXPECT_EQ(read("0." + std::string(6000, '0') + "1"), 0);
    EXPECT_EQ(read("1e-99999"), 0);
    EXPECT_EQ(read("1E-99999999999999999999"), 0);
    EXPECT_EQ(read("1e-400"), 0);
    EXPECT_EQ(readFileNumber<std::int64_t>("-99999999999999999999"),
              std::numeric_limits<std::int64_t>::min());
}

TEST(ReadObj, RefusesWhatIsNoIndex) {
    for (const std::string word : {"0", "x", "1.5", "/1", "+-1", "0/1"})
        EXPECT_TRUE(says(refusal(replaced(twoObj(), "f 2 5 6 3", "f 2 5 6 " + word), "a.obj"),
                         "^line 8: face 1: \"" + word + "\" is no vertex index"));
}

TEST(ReadObj, TakesTrianglesWithoutALastLineEndForTriangles) {
    const std::string triangles = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4";
    EXPECT_TRUE(says(refusal(triangles, "a.obj"), "^face 0 (line 5): it has 3 sides", "quads of all faces"));
}

TEST(ReadObj, RefusesZeroBytesThatHideLines) {
    const std::string zeros(64, '\0');
    EXPECT_TRUE(says(refusal(replaced(twoObj(), "f 2 5 6 3", zeros + "f 2 5 6 3"), "a.obj"),
                     "^line 8: it holds a zero byte", "damaged"));
    EXPECT_TRUE(says(refusal(twoObj() + zeros, "a.obj"), "^line 9: it holds a zero byte"));
    EXPECT_TRUE(says(refusal(zeros, "a.obj"), "^line 1: it holds a zero byte"));
    expectTwoSquares(twoObj() + zeros.substr(0, 1), "a.obj");
}

TEST(ReadObj, RefusesWhatWasCutOff) {
    EXPECT_TRUE(says(refusal(replaced(twoObj(), "f 2 5 6 3\n", "f 2 5"), "a.obj"),
                     "^face 1 (line 8): the last line ends after 2 corners", "cut off"));
    EXPECT_TRUE(says(refusal("v 0 0 0\nv 1 0", "a.obj"), "cut off"));
    EXPECT_TRUE(says(refusal("v 0 0 0\nv 1 0 0", "a.obj"), "holds no faces"));
    EXPECT_TRUE(says(refusal(replaced(twoObj(), "f 2 5 6 3\n", "f 2 5 6 -"), "a.obj"), "cut off"));
}

} // namespace
} // namespace qm
