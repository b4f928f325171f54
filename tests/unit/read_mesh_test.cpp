#include "base/error.h"
#include "mesh/quad_geometry.h"
#include "mesh/read_mesh.h"
#include "mesh/suspicions.h"
#include "mesh/topology.h"
#include "mesh/write_soup.h"
#include "shape/shape.h"
#include "support/mesh_text.h"
#include "support/shared_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>

namespace qm {
namespace {

using testing::FaceIndices;
using testing::facesOf;
using testing::pointsOf;

QuadMesh read(const std::string& text, const std::string& name) {
    return readMesh(text, name).mesh;
}

/// What is said of bytes that must be refused.
std::string refusal(const std::string& text, const std::string& name) {
    try {
        (void)readMesh(text, name);
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line";
        return error.what();
    }
    ADD_FAILURE() << "accepted:\n" << text.substr(0, 300);
    return {};
}

/// A message contains all the parts, begins with one that has '^' before it, and lacks those with '!'.
template <class... Parts>::testing::AssertionResult says(const std::string& message, const Parts&... parts) {
    for (const std::string& part : {std::string(parts)...}) {
        const bool fits = part.starts_with('^')   ? message.starts_with(part.substr(1))
                          : part.starts_with('!') ? message.find(part.substr(1)) == std::string::npos
                                                  : message.find(part) != std::string::npos;
        if (!fits)
            return ::testing::AssertionFailure() << '"' << message << "\" does not fit \"" << part << '"';
    }
    return ::testing::AssertionSuccess();
}

/// Two squares side by side.
const std::string twoObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                           "f 1 2 3 4\nf 2 5 6 3\n";
const std::string twoOff = "OFF\n6 2 7\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n"
                           "4 0 1 2 3\n4 1 4 5 2\n";
const std::string twoPlyHeader = "ply\nformat ascii 1.0\ncomment two squares\nelement vertex 6\n"
                                 "property float x\nproperty float y\nproperty float z\nelement face 2\n"
                                 "property list uchar int vertex_indices\nend_header\n";
const std::string twoPly = twoPlyHeader + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n"
                                          "4 0 1 2 3\n4 1 4 5 2\n";

void expectTwoSquares(const std::string& text, const std::string& name) {
    SCOPED_TRACE(text.substr(0, 400));
    const QuadMesh mesh = read(text, name);
    EXPECT_EQ(pointsOf(mesh), pointsOf(read(twoObj, "a.obj")));
    EXPECT_EQ(facesOf(mesh), (std::vector<FaceIndices>{{0, 1, 2, 3}, {1, 4, 5, 2}}));
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

// ------------------------------------------------------------------------------- all formats: what is read

TEST(ReadMesh, KeepsNumbersAndFirstVertices) {
    expectTwoSquares(twoObj, "a.obj");
    expectTwoSquares(twoOff, "a.off");
    expectTwoSquares(twoPly, "a.ply");
}

TEST(ReadMesh, KnowsFormatsByExtensionOrFirstWord) {
    expectTwoSquares(twoObj, "A.OBJ");
    for (const std::string name : {"", "mesh", "-", "folder.off/mesh", "mesh.txt"}) {
        expectTwoSquares(twoObj, name);
        expectTwoSquares("# a comment\n\n" + twoObj, name);
        expectTwoSquares("mtllib a.mtl\n" + twoObj, name);
        expectTwoSquares(twoOff, name);
        expectTwoSquares("# a comment\n" + twoOff, name);
        expectTwoSquares(twoPly, name);
    }
    EXPECT_TRUE(says(refusal("solid cube\n", "a.stl"), "line 1", "but the file ends"));
    EXPECT_TRUE(says(refusal(std::string("\0\1\2", 3), ""), "format is not known"));
    EXPECT_TRUE(says(refusal("   \n", ""), "format is not known"));
}

TEST(ReadMesh, UnderstandsAnyLineEnd) {
    for (const std::string end : {"\r\n", "\r", " \t \n", "\n\n"}) {
        expectTwoSquares(replaced(twoObj, "\n", end), "a.obj");
        expectTwoSquares(replaced(twoOff, "\n", end), "a.off");
        if (end != "\n\n") expectTwoSquares(replaced(twoPly, "\n", end), "a.ply");
    }
}

TEST(ReadMesh, NeedsNoFinalLineEnd) {
    expectTwoSquares(twoObj.substr(0, twoObj.size() - 1), "a.obj");
    expectTwoSquares(twoOff.substr(0, twoOff.size() - 1), "a.off");
    expectTwoSquares(twoPly.substr(0, twoPly.size() - 1), "a.ply");
}

TEST(ReadMesh, SkipsTheByteOrderMark) {
    expectTwoSquares("\xEF\xBB\xBF" + twoObj, "a.obj");
    expectTwoSquares("\xEF\xBB\xBF" + twoOff, "a.off");
    expectTwoSquares("\xEF\xBB\xBF" + twoPly, "a.ply");
}

TEST(ReadMesh, AllowsTabsAndIndents) {
    expectTwoSquares(replaced(replaced(twoObj, " ", "\t \v"), "\n", "\n  "), "a.obj");
    expectTwoSquares(replaced(replaced(twoOff, " ", "\t\f"), "\n", "\n\t"), "a.off");
}

TEST(ReadMesh, ReadsNumbersToTheLastBit) {
    const std::string text = "v 0.1 1e-300 -1.7976931348623157e-5\nv +1 -0 .5\nv 1. 1E2 1e+2\n"
                             "v 4.9e-324 1e-999 123456789012345678901234567890\nf 1 2 3 4\n";
    const QuadMesh mesh = read(text, "a.obj");
    EXPECT_EQ(mesh.point(VertexId(0)), Point(0.1, 1e-300, -1.7976931348623157e-5));
    EXPECT_EQ(mesh.point(VertexId(1)), Point(1, 0, 0.5));
    EXPECT_EQ(mesh.point(VertexId(2)), Point(1, 100, 100));
    EXPECT_EQ(mesh.point(VertexId(3)), Point(4.9e-324, 0, 123456789012345678901234567890.));
}

TEST(ReadMesh, KeepsIsolatedVertices) {
    const QuadMesh mesh = read("v 9 9 9\n" + replaced(twoObj, "f 1 2 3 4\nf 2 5 6 3", "f 2 3 4 5"), "a.obj");
    EXPECT_EQ(mesh.n_vertices(), 7U);
    EXPECT_TRUE(mesh.is_isolated(VertexId(0)));
}

TEST(ReadMesh, AcceptsTwoQuadsBackToBack) {
    const QuadMesh mesh = read(replaced(twoObj, "f 2 5 6 3", "f 4 3 2 1"), "a.obj");
    EXPECT_EQ(mesh.n_edges(), 4U);
}

// ---------------------------------------------------------------------------------------------------- OBJ

TEST(ReadObj, UnderstandsTextureAndNormalIndices) {
    expectTwoSquares(replaced(twoObj, "f 1 2 3 4\nf 2 5 6 3", "f 1/1 2/2 3/3 4/4\nf 2/2/1 5//1 6/6/6 3/"),
                     "a.obj");
}

TEST(ReadObj, UnderstandsRelativeIndices) {
    expectTwoSquares(replaced(twoObj, "f 1 2 3 4\nf 2 5 6 3", "f -6 -5 -4 -3\nf -5/-1 -2 -1 -4"), "a.obj");
    // They count from where the face stands.
    const QuadMesh mesh =
        read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\nv 2 0 0\nv 2 1 0\nf -5 -2 -1 -4\n", "");
    EXPECT_EQ(facesOf(mesh)[1], (FaceIndices{1, 4, 5, 2}));
}

TEST(ReadObj, AllowsFacesBeforeTheirVertices) {
    expectTwoSquares("f 1 2 3 4\nf 2 5 6 3\n" + twoObj.substr(0, twoObj.find('f')), "a.obj");
}

TEST(ReadObj, PassesOverEverythingElse) {
    expectTwoSquares("mtllib x.mtl\no thing\ng a b # c\ns off\nvt 0 0\nvn 0 0 1\nvp 1\nusemtl m\nl 1 2\np 1\n"
                     "curv 0 1 1 2\nnonsense here\nV 1 2\n" +
                         twoObj + "#f 1 2 3\n",
                     "a.obj");
}

TEST(ReadObj, PassesOverColoursAndWeights) {
    expectTwoSquares(replaced(twoObj, " 0\n", " 0 0.5 0.5 0.5\n"), "a.obj");
    expectTwoSquares(replaced(twoObj, " 0\n", " 0 1.0\n"), "a.obj");
}

TEST(ReadObj, JoinsContinuedLines) {
    expectTwoSquares(replaced(twoObj, "f 1 2 3 4", "f 1 2 \\\n 3 \\\n4"), "a.obj");
    expectTwoSquares(replaced(twoObj, "f 1 2 3 4", "f 1 2\\\r\n3 4"), "a.obj");
    expectTwoSquares(replaced(twoObj, "v 2 0 0", "v 2 \\\n0 0"), "a.obj");
    // A comment ends with its line, whatever its last character is.
    expectTwoSquares("# C:\\meshes\\\n" + twoObj, "a.obj");
}

TEST(ReadObj, CountsLinesInMessages) {
    EXPECT_TRUE(
        says(refusal("# 1\nv 0 0\\\n 0\nv 1 x 0\n", "a.obj"), "^line 4: vertex 1: \"x\" is no number"));
    EXPECT_TRUE(says(refusal("# 1\r# 2\rv 1 x 0\r", "a.obj"), "^line 3: "));
}

TEST(ReadObj, RefusesWhatIsNoNumber) {
    for (const std::string word : {"x", "1,5", "0x1", "1.0.0", "+-1", "--1", "1e", "\x80\x1b"})
        EXPECT_TRUE(says(refusal(replaced(twoObj, "v 2 1 0", "v 2 " + word + " 0"), "a.obj"),
                         "^line 6: vertex 5", "is no number"));
    EXPECT_TRUE(says(refusal(replaced(twoObj, "v 2 1 0", "v 2 1"), "a.obj"), "fewer than three coordinates"));
    EXPECT_TRUE(says(refusal(replaced(twoObj, "v 2 1 0", "v 2 " + std::string(1000, 'x')), "a.obj"), "..."));
}

TEST(ReadObj, RefusesWhatIsNoIndex) {
    for (const std::string word : {"0", "x", "1.5", "/1", "+-1", "0/1"})
        EXPECT_TRUE(says(refusal(replaced(twoObj, "f 2 5 6 3", "f 2 5 6 " + word), "a.obj"),
                         "^line 8: face 1: \"" + word + "\" is no vertex index"));
}

TEST(ReadObj, RefusesWhatWasCutOff) {
    EXPECT_TRUE(says(refusal(replaced(twoObj, "f 2 5 6 3\n", "f 2 5"), "a.obj"),
                     "^face 1 (line 8): the last line ends after 2 vertices", "cut off"));
    EXPECT_TRUE(says(refusal("v 0 0 0\nv 1 0", "a.obj"), "cut off"));
    EXPECT_TRUE(says(refusal("v 0 0 0\nv 1 0 0", "a.obj"), "holds no faces"));
    EXPECT_TRUE(says(refusal(replaced(twoObj, "f 2 5 6 3\n", "f 2 5 6 -"), "a.obj"), "cut off"));
}

// ---------------------------------------------------------------------------------------------------- OFF

TEST(ReadOff, UnderstandsTheKindsOfHeader) {
    for (const std::string header :
         {"OFF 6 2 7\n", "OFF\n\n# c\n6 2 7 # c\n", "OFF\n6 2\n", "6 2 7\n", "OFF\n6\n2\n7\n",
          "COFF\n6 2 0\n", "NOFF\n6 2 0\n", "STCNOFF 6 2 0\n", "OFF 6\n2 7\n"})
        expectTwoSquares(replaced(twoOff, "OFF\n6 2 7\n", header), "a.off");
}

TEST(ReadOff, PassesOverColours) {
    expectTwoSquares(replaced(twoOff, " 0\n", " 0 255 0 0 255\n"), "a.off");
    expectTwoSquares(replaced(replaced(twoOff, "2 3\n", "2 3 0.5 0.5 0.5\n"), "5 2\n", "5 2 7\n"), "a.off");
}

TEST(ReadOff, AllowsElementsSpreadOverLines) {
    const std::string body = twoOff.substr(twoOff.find("0 0 0"));
    expectTwoSquares("OFF\n6 2 7\n" + replaced(body, " ", "\n"), "a.off");
    expectTwoSquares("OFF\n6 2 7\n" + replaced(body, " ", "\n\n# comment\n"), "a.off");
}

TEST(ReadOff, AllowsAFileWithoutLines) {
    expectTwoSquares(replaced(twoOff, "\n", " "), "a.off");
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
    for (std::size_t size = twoOff.size() - 2; size > 12; --size)
        EXPECT_FALSE(refusal(twoOff.substr(0, size), "a.off").empty());
    EXPECT_TRUE(
        says(refusal(twoOff.substr(0, 30), "a.off"), "the file ends after 3 vertices, its header says 6"));
    EXPECT_TRUE(says(refusal(twoOff.substr(0, twoOff.size() - 10), "a.off"),
                     "the file ends after 1 faces, its header says 2"));
}

TEST(ReadOff, RefusesMoreThanItsHeaderSays) {
    EXPECT_TRUE(says(refusal(replaced(twoOff, "6 2 7", "6 1 7"), "a.off"),
                     "^line 10: the file goes on after the 1 faces"));
}

TEST(ReadOff, AllocatesNothingForAHostileHeader) {
    for (const std::string count : {"1000000000000", "9223372036854775807", "99999999999999999999999"}) {
        EXPECT_TRUE(says(refusal("OFF\n" + count + " 1 0\n0 0 0\n", "a.off"), "file ends after 1 vertices"));
        EXPECT_TRUE(says(refusal("OFF\n1 " + count + " 0\n0 0 0\n", "a.off"), "file ends after 0 faces"));
        EXPECT_TRUE(says(refusal("OFF\n1 1 0\n0 0 0\n" + count + " 1 1 1 1\n", "a.off"),
                         "cannot have that many vertices"));
    }
}

TEST(ReadOff, TakesNoHugeIndexForAnother) {
    EXPECT_TRUE(says(refusal(replaced(twoOff, "1 4 5 2", "1 4 5 99999999999999999999999"), "a.off"),
                     "is out of range"));
    EXPECT_TRUE(says(refusal(replaced(twoOff, "1 4 5 2", "1 4 5 4294967298"), "a.off"), "is out of range"));
    EXPECT_TRUE(says(refusal(replaced(twoOff, "1 4 5 2", "1 4 5 2.0"), "a.off"), "is no whole number"));
}

TEST(ReadOff, SaysThatIndicesSeemToCountFromOne) {
    EXPECT_TRUE(
        says(refusal(replaced(replaced(twoOff, "4 0 1 2 3", "4 1 2 3 4"), "4 1 4 5 2", "4 2 5 6 3"), "a.off"),
             "^face 1 (line 10): vertex index 6 is out of range", "count from 1"));
}

// ---------------------------------------------------------------------------------------------------- PLY

/// The two squares in binary, with whatever else a file may hold.
std::string binaryPly(bool little, const std::string& coordinate, const std::string& index, bool extras) {
    testing::BinaryText out(little);
    std::string header = std::string("ply\nformat binary_") + (little ? "little" : "big") + "_endian 1.0\n";
    if (extras)
        header += "comment end_header is not here\nobj_info x\nelement material 2\nproperty uchar red\n";
    header += "element vertex 6\n";
    if (extras) header += "property list uchar short tags\n";
    for (const char axis : {'x', 'y', 'z'})
        header += "property " + coordinate + " " + axis + "\n";
    if (extras) header += "property double quality\n";
    header +=
        "element face 2\nproperty list uchar " + index + " vertex_" + (extras ? "index" : "indices") + "\n";
    if (extras) header += "property uint flags\nelement empty 1000000000000\n";
    out.bytes = header + "end_header\n";
    if (extras) out.bytes += "\n\r";
    const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                                    {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
    for (const auto& point : points) {
        if (extras) {
            out.put("uchar", 2);
            out.put("short", 7);
            out.put("short", -7);
        }
        for (const double value : point)
            out.put(coordinate, value);
        if (extras) out.put("double", 0.25);
    }
    for (const auto& face : std::vector<std::array<int, 4>>{{0, 1, 2, 3}, {1, 4, 5, 2}}) {
        out.put("uchar", 4);
        for (const int corner : face)
            out.put(index, corner);
        if (extras) out.put("uint", 5);
    }
    return out.bytes;
}

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
    std::string text = replaced(twoPly, "property float z\n", "property float z\nproperty uchar red\n");
    text = replaced(text, " 0\n", " 0 255\n");
    expectTwoSquares(text, "a.ply");
}

TEST(ReadPly, TakesPropertiesByName) {
    std::string text = replaced(twoPlyHeader, "property float x\nproperty float y\nproperty float z\n",
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
        EXPECT_TRUE(says(refusal(replaced(twoPlyHeader, line, ""), "a.ply"), reason)) << line;
    EXPECT_TRUE(says(refusal(replaced(twoPly, "float y", "real y"), "a.ply"), "line 6: \"real\" is no type"));
    EXPECT_TRUE(
        says(refusal(replaced(twoPly, "ascii", "utf8"), "a.ply"), "format \"utf8\" is not understood"));
    EXPECT_TRUE(says(refusal(replaced(twoPly, "vertex 6", "vertex six"), "a.ply"), "has no count"));
    EXPECT_TRUE(says(refusal(replaced(twoPly, "vertex 6", "vertex -6"), "a.ply"), "has no count"));
    EXPECT_TRUE(says(refusal(replaced(twoPly, "list uchar", "list float"), "a.ply"), "length of a list"));
    EXPECT_TRUE(says(refusal(replaced(twoPly, "float z\n", "float z\nproperty float x\n"), "a.ply"),
                     "one x, y and z"));
    EXPECT_TRUE(says(refusal(replaced(twoPly, "element face", "element vertex"), "a.ply"), "occurs twice"));
    EXPECT_TRUE(says(refusal("OFF\n", "a.ply"), "does not begin with ply"));
}

TEST(ReadPly, RefusesWhatWasCutOff) {
    for (const std::string& whole :
         {twoPly.substr(0, twoPly.size() - 1), binaryPly(true, "float", "int", false),
          binaryPly(false, "double", "ushort", true)})
        for (std::size_t size = 1; size < whole.size(); ++size)
            EXPECT_FALSE(refusal(whole.substr(0, size), "a.ply").empty()) << size;
    EXPECT_TRUE(says(refusal(twoPly.substr(0, twoPly.size() - 4), "a.ply"),
                     "face 1 (line 18): the file ends there, its header announces 2"));
}

TEST(ReadPly, RefusesMoreThanItsHeaderSays) {
    EXPECT_TRUE(says(refusal(replaced(twoPly, "face 2", "face 1"), "a.ply"), "^line 18: the file goes on"));
    EXPECT_TRUE(says(refusal(binaryPly(true, "float", "int", false) + "x", "a.ply"), "the file goes on"));
    expectTwoSquares(binaryPly(true, "float", "int", false) + "\n", "a.ply");
}

TEST(ReadPly, RefusesBadIndicesAndLengths) {
    EXPECT_TRUE(says(refusal(replaced(twoPly, "4 1 4 5 2", "4 1 4 5 2.5"), "a.ply"),
                     "face 1 (line 18): a vertex index is no whole number"));
    EXPECT_TRUE(says(refusal(replaced(twoPly, "4 1 4 5 2", "4 1 4 5 nan"), "a.ply"), "no whole number"));
    EXPECT_TRUE(says(refusal(replaced(twoPly, "4 1 4 5 2", "4 1 4 5 1e300"), "a.ply"), "out of range"));
    EXPECT_TRUE(
        says(refusal(replaced(twoPly, "4 1 4 5 2", "4 1 4 5 -1"), "a.ply"), "index -1 is out of range"));
    EXPECT_TRUE(says(refusal(replaced(twoPly, "4 1 4 5 2", "-4 1 4 5 2"), "a.ply"), "impossible length"));
    EXPECT_TRUE(says(refusal(replaced(twoPly, "4 1 4 5 2", "1e18 1 4 5 2"), "a.ply"), "impossible length"));
    EXPECT_TRUE(says(refusal(replaced(twoPly, "4 1 4 5 2", "4 1 four 5 2"), "a.ply"),
                     "line 18: \"four\" is no number"));
}

TEST(ReadPly, AllocatesNothingForAHostileHeader) {
    EXPECT_TRUE(says(refusal(replaced(twoPly, "vertex 6", "vertex 9000000000000000000"), "a.ply"),
                     "header announces"));
    EXPECT_TRUE(
        says(refusal(replaced(binaryPly(true, "float", "int", false), "face 2", "face 9000000000000000000"),
                     "a.ply"),
             "face 2: the file ends there"));
}

// ---------------------------------------------------------------------------- what is no oriented manifold

std::string objOf(const std::string& vertices, const std::string& faces) {
    return vertices + faces;
}

/// Vertices 1 to 12 of a 4 x 3 grid.
const std::string gridPoints = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n"
                               "v 0 2 0\nv 1 2 0\nv 2 2 0\nv 3 2 0\n";

TEST(Refusal, OfAnEmptyFile) {
    for (const std::string name : {"a.obj", "a.off", "a.ply", ""})
        EXPECT_TRUE(says(refusal("", name), "the file is empty"));
    for (const std::string text : {"\n", "# nothing\n", "v 0 0 0\n"})
        EXPECT_TRUE(says(refusal(text, "a.obj"), "holds no faces"));
    EXPECT_TRUE(says(refusal("OFF\n0 0 0\n", "a.off"), "holds no faces"));
}

TEST(Refusal, OfOtherPolygonsSaysHowMany) {
    EXPECT_TRUE(says(
        refusal(objOf(gridPoints, "f 1 2 6 5\nf 2 3 7\nf 3 4 8 7\nf 5 6 9\nf 6 7 8 12 11 10\n"), "a.obj"),
        "^face 1 (line 14): it has 3 sides; 3 of 5 faces are not four-sided"));
    EXPECT_TRUE(
        says(refusal(objOf(gridPoints, "f\n"), "a.obj"), "it has 0 sides; 1 of 1 face is not four-sided"));
}

TEST(Refusal, OfIndicesOutOfRange) {
    EXPECT_TRUE(
        says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 2 3 7 13\n"), "a.obj"),
             "^face 1 (line 14): vertex index 12 is out of range: there are 12 vertices, counted from 0"));
    EXPECT_TRUE(
        says(refusal(objOf(gridPoints, "f -1 -2 -3 -13\n"), "a.obj"), "vertex index -1 is out of range"));
    EXPECT_TRUE(says(refusal("f 1 2 3 4\n", "a.obj"), "there are 0 vertices"));
}

TEST(Refusal, OfPlacesThatAreNone) {
    for (const std::string word : {"nan", "NaN", "-nan", "nan(ind)"})
        EXPECT_TRUE(says(refusal(replaced(twoObj, "v 2 1 0", "v 2 " + word + " 0"), "a.obj"),
                         "^vertex 5 (line 6): a coordinate is not a number"));
    for (const std::string word : {"inf", "-inf", "Infinity", "1e999", "-1e400", "1e99999999999"})
        EXPECT_TRUE(says(refusal(replaced(twoObj, "v 2 1 0", "v 2 " + word + " 0"), "a.obj"),
                         "^vertex 5 (line 6): a coordinate is infinite"));
    EXPECT_TRUE(says(refusal(replaced(twoObj, "v 2 1 0", "v 2 1e200 0"), "a.obj"), "larger than 1e150"));
    EXPECT_TRUE(says(refusal(replaced(twoPly, "2 1 0\n", "2 nan 0\n"), "a.ply"),
                     "^vertex 5 (line 16): a coordinate is not"));
    EXPECT_TRUE(says(refusal(replaced(twoOff, "2 1 0\n", "2 inf 0\n"), "a.off"),
                     "^vertex 5 (line 8): a coordinate is inf"));
}

TEST(Refusal, OfARepeatedVertex) {
    EXPECT_TRUE(says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 2 3 7 3\n"), "a.obj"),
                     "^face 1 (line 14): vertex 2 occurs twice in it", "--repair"));
}

TEST(Refusal, OfADuplicateFace) {
    for (const std::string twin : {"1 2 6 5", "6 5 1 2"})
        EXPECT_TRUE(says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 2 3 7 6\nf " + twin + "\n"), "a.obj"),
                         "^face 2 (line 15): it has the same vertices as face 0 (line 13)", "--repair"));
    // The other way round it is one too, as soon as it has neighbours.
    EXPECT_TRUE(
        says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 2 3 7 6\nf 5 6 2 1\n"), "a.obj"), "same vertices"));
    EXPECT_TRUE(says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 1 2 6 5\n"), "a.obj"), "same vertices"));
}

TEST(Refusal, OfACrowdedEdge) {
    EXPECT_TRUE(says(
        refusal(objOf(gridPoints + "v 1 0 1\nv 1 1 1\n", "f 1 2 6 5\nf 2 3 7 6\nf 2 6 14 13\n"), "a.obj"),
        "^edge between vertices 1 and 5: 3 faces meet there: face 0 (line 15), face 1 (line 16), "
        "face 2 (line 17). "));
}

TEST(Refusal, OfInconsistentOrientation) {
    EXPECT_TRUE(says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 2 3 7 6\nf 3 7 8 4\n"), "a.obj"),
                     "^edge between vertices 2 and 6: face 1 (line 14) and face 2 (line 15) are "
                     "oriented inconsistently, as at 1 edge in all",
                     "--repair orients them"));
}

/// A ring of squares; the ends are joined after half a turn if it is to have one side only.
std::string ring(int squares, bool halfTurn) {
    std::string text;
    for (int k = 0; k < squares; ++k)
        text += "v " + std::to_string(k) + " 0 0\nv " + std::to_string(k) + " 1 0\n";
    for (int k = 0; k < squares; ++k) {
        int a = 2 * k + 1, b = 2 * k + 2, c = 2 * k + 3, d = 2 * k + 4;
        if (k + 1 == squares) {
            c = halfTurn ? 2 : 1;
            d = halfTurn ? 1 : 2;
        }
        text += "f " + std::to_string(a) + " " + std::to_string(c) + " " + std::to_string(d) + " " +
                std::to_string(b) + "\n";
    }
    return text;
}

TEST(Refusal, OfASurfaceWithOneSide) {
    EXPECT_TRUE(says(refusal(ring(6, true), "a.obj"), "not orientable", "!--repair"));
    EXPECT_EQ(read(ring(6, false), "a.obj").n_faces(), 6U);
}

TEST(Refusal, OfAVertexWithSeveralFans) {
    EXPECT_TRUE(says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 6 7 11 10\n"), "a.obj"),
                     "^vertex 5 (line 6): the faces around it fall into several fans"));
}

TEST(Refusal, OfASaturatedVertexWithOneMoreFan) {
    const QuadMesh cube = makeShape("cube", {.resolution = 1});
    std::string text = writeObj(cube);
    text += "v 5 5 5\nv 6 5 5\nv 6 6 5\nf 1 9 10 11\n";
    EXPECT_TRUE(
        says(refusal(text, "a.obj"), "vertex 0 (line 1): the faces around it fall into several fans"));
}

// ----------------------------------------------------------------------------------------------- warnings

std::vector<std::string> warningsOf(const std::string& text) {
    return suspicions(readMesh(text, "a.obj").mesh);
}

std::string onlyOne(const std::vector<std::string>& warnings) {
    EXPECT_EQ(warnings.size(), 1U);
    return warnings.empty() ? "" : warnings.front();
}

TEST(Warnings, AreSilentAboutAGoodMesh) {
    EXPECT_EQ(warningsOf(writeObj(makeShape("block"))), std::vector<std::string>());
    EXPECT_EQ(warningsOf(twoObj), std::vector<std::string>());
}

TEST(Warnings, AboutCoincidentVertices) {
    EXPECT_TRUE(
        says(onlyOne(warningsOf(twoObj + "v 2 1 0\nv -0 0 0\n")), "2 of 8 vertices lie where another does"));
}

TEST(Warnings, AboutQuadsWithoutArea) {
    EXPECT_TRUE(says(onlyOne(warningsOf("v 0 0 0\nv 1 0 0\nv 3 0 0\nv 2 0 0\nf 1 2 3 4\n")),
                     "1 of 1 quads has no area"));
}

TEST(Warnings, AboutManyComponents) {
    std::string text;
    for (int k = 0; k < 11; ++k)
        text += replaced("v X 0 0\nv X 1 0\nv X 1 1\nv X 0 1\nf -4 -3 -2 -1\n", "X", std::to_string(k));
    EXPECT_TRUE(says(onlyOne(warningsOf(text)), "the mesh has 11 components"));
    std::string lonely = twoObj;
    for (int k = 0; k < 20; ++k)
        lonely += "v 9 9 " + std::to_string(k) + "\n";
    EXPECT_EQ(warningsOf(lonely), std::vector<std::string>()) << "vertices without faces are no components";
}

TEST(Warnings, AboutManyExtraordinaryVertices) {
    EXPECT_TRUE(says(onlyOne(warningsOf(writeObj(makeShape("cube", {.resolution = 1})))),
                     "8 of 8 vertices are extraordinary"));
    EXPECT_EQ(warningsOf(writeObj(makeShape("cube", {.resolution = 4}))), std::vector<std::string>());
}

// ------------------------------------------------------------------------------------------------ writing

TEST(WriteObj, ReadsBackExactly) {
    for (const ShapeKind& kind : shapeKinds()) {
        const QuadMesh mesh = makeShape(kind.name);
        const QuadMesh again = read(writeObj(mesh), "a.obj");
        EXPECT_EQ(pointsOf(again), pointsOf(mesh)) << kind.name;
        EXPECT_EQ(facesOf(again), facesOf(mesh)) << kind.name;
    }
}

TEST(WriteObj, KeepsFirstVerticesAndIsolatedOnes) {
    const std::string text = "v 0.1 -1e-300 3\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 7 7 7\nf 3 4 1 2\n";
    EXPECT_EQ(writeObj(read(text, "a.obj")), text);
}

// ------------------------------------------------------------------------------ the mesh that is built

TEST(BuiltMesh, IsConsistent) {
    for (const ShapeKind& kind : shapeKinds()) {
        const QuadMesh mesh = makeShape(kind.name, {.resolution = 3});
        testing::expectConsistent(mesh);
    }
}

TEST(BuiltMesh, HandlesAVertexOfHighValence) {
    // A fan of 100,000 quads: going around the vertex for each of them would take minutes.
    constexpr int quads = 100'000;
    std::string text = "v 0 0 0\n";
    for (int k = 0; k < 2 * quads; ++k)
        text += "v 1 " + std::to_string(k) + " 0\n";
    for (int k = 0; k < quads; ++k)
        text += "f 1 " + std::to_string(2 + 2 * k) + " " + std::to_string(3 + 2 * k) + " " +
                std::to_string(2 + (2 * k + 2) % (2 * quads)) + "\n";
    EXPECT_EQ(read(text, "a.obj").valence(VertexId(0)), static_cast<unsigned>(quads));
}

TEST(BuiltMesh, OfManyFacesAtOneEdgeIsRefusedQuickly) {
    std::string text = "v 0 0 0\nv 1 0 0\n";
    for (int k = 0; k < 100'000; ++k)
        text += "v 1 1 " + std::to_string(k) + "\nv 0 1 " + std::to_string(k) + "\nf 1 2 -2 -1\n";
    EXPECT_TRUE(says(refusal(text, "a.obj"), "100000 faces meet there"));
}

// ------------------------------------------------------------------------------------------- real meshes

TEST(SharedMeshes, OfDevAreAccepted) {
    const auto names = testing::sharedFiles("dev");
    if (names.empty()) GTEST_SKIP() << "no shared meshes";
    for (const std::string& name : names) {
        SCOPED_TRACE(name);
        EXPECT_NO_THROW(testing::expectConsistent(read(*testing::sharedFile(name), name)));
    }
}

TEST(SharedMeshes, OfBadAreRefusedForTheRightReason) {
    if (testing::sharedFiles("bad").empty()) GTEST_SKIP() << "no shared meshes";
    const std::map<std::string, std::string> reasons{
        {"empty.obj", "the file is empty"},
        {"flipped_faces.obj", "at 624 edges in all. The option --repair orients them"},
        {"gmsh_nut.obj", "at 24 edges in all. The option --repair"},
        {"moebius.obj", "not orientable"},
        {"nan_coords.obj", "vertex 10 (line 11): a coordinate is not a number"},
        {"nonmanifold_edge.obj", "3 faces meet there"},
        {"one_based.off", "count from 1"},
        {"quad_dominant.obj", "94 of 2981 faces"},
        {"repeated_vertex_face.obj", "face 100 (line 1000): vertex 249 occurs twice"},
        {"rockerarm_nonmanifold.obj", "4 faces meet there"},
        {"suzanne_mixed.obj", "32 of 500 faces are not four-sided"},
        {"triangles_only.obj", "2796 of 2796 faces"},
        {"truncated.obj", "face 130 (line 1180): the last line ends after 1 vertex"},
    };
    for (const auto& [name, reason] : reasons)
        EXPECT_TRUE(says(refusal(*testing::sharedFile("bad/" + name), name), reason)) << name;
}

TEST(SharedMeshes, WithUnusualSyntaxAreTheSame) {
    const auto plain = testing::sharedFile("dev/fandisk_qex.obj");
    if (!plain) GTEST_SKIP() << "no shared meshes";
    const QuadMesh expected = read(*plain, "a.obj"),
                   found = read(*testing::sharedFile("dev/awkward_valid.obj"), "a.obj");
    EXPECT_LT(testing::largestDistance(found, expected), 1e-5); // it was written with fewer digits
    EXPECT_EQ(facesOf(found), facesOf(expected));
}

// ------------------------------------------------------------------------------------------ mutated files

/// Changes a few places: bytes, numbers, lines, the length.
std::string mutated(std::string text, std::mt19937_64& engine) {
    const auto below = [&](std::size_t bound) { return engine() % std::max<std::size_t>(bound, 1); };
    const std::vector<std::string> words{
        "-1", "0", "nan", "1e400", "99999999999999999999", "\r", "\n", "\\\n", "#", "f", "v", "/", "4", " "};
    for (std::size_t change = below(4) + 1; change > 0; --change) {
        const std::size_t at = below(text.size());
        switch (below(6)) {
        case 0: // any byte
            if (!text.empty()) text[at] = static_cast<char>(below(256));
            break;
        case 1: // a digit
            if (!text.empty()) text[at] = static_cast<char>('0' + below(10));
            break;
        case 2:
            text.resize(at);
            break;
        case 3:
            text.insert(at, words[below(words.size())]);
            break;
        case 4:
            text.erase(at, below(30));
            break;
        default: // a piece of it again, elsewhere
            text.insert(at, text.substr(below(text.size() + 1), below(60)));
        }
    }
    return text;
}

TEST(MutatedFiles, AreRefusedOrValid) {
    std::mt19937_64 engine(7);
    const std::string cube = writeObj(makeShape("cube", {.resolution = 2}));
    std::vector<std::pair<std::string, std::string>> originals{
        {twoObj, "a.obj"}, {cube, "a.obj"}, {twoOff, "a.off"}, {twoPly, "a.ply"}};
    for (const bool little : {true, false})
        originals.emplace_back(binaryPly(little, "float", "int", little), "a.ply");
    std::size_t valid = 0, refused = 0;
    for (int round = 0; round < 1000; ++round)
        for (const auto& [text, name] : originals)
            for (const bool repair : {false, true}) {
                const std::string bytes = mutated(text, engine);
                try {
                    testing::expectConsistent(readMesh(bytes, name, {repair}).mesh);
                    ++valid;
                } catch (const Error&) {
                    ++refused;
                }
                if (HasFailure()) FAIL() << "round " << round << "\n" << bytes;
            }
    EXPECT_GT(valid, 100U);
    EXPECT_GT(refused, 100U);
}

} // namespace
} // namespace qm
