#include "base/error.h"
#include "mesh/files/read_mesh.h"
#include "mesh/files/write_soup.h"
#include "mesh/suspicions.h"
#include "mesh/topology.h"
#include "shape/shape.h"
#include "support/mesh_text.h"
#include "support/shared_files.h"
#include "support/two_squares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace qm {
namespace {

using namespace test;

// ------------------------------------------------------------------------------------------ what is read

TEST(ReadMesh, KeepsNumbersAndFirstVertices) {
    expectTwoSquares(twoObj(), "a.obj");
    expectTwoSquares(twoOff(), "a.off");
    expectTwoSquares(twoPly(), "a.ply");
}

TEST(ReadMesh, KnowsFormatsByExtensionOrFirstWord) {
    expectTwoSquares(twoObj(), "A.OBJ");
    for (const std::string name : {"", "mesh", "-", "folder.off/mesh", "mesh.txt"}) {
        expectTwoSquares(twoObj(), name);
        expectTwoSquares("# a comment\n\n" + twoObj(), name);
        expectTwoSquares("mtllib a.mtl\n" + twoObj(), name);
        expectTwoSquares(twoOff(), name);
        expectTwoSquares("# a comment\n" + twoOff(), name);
        expectTwoSquares(twoPly(), name);
    }
    EXPECT_TRUE(says(refusal("solid cube\n", "a.stl"), "line 1", "but the file ends"));
    EXPECT_TRUE(says(refusal(std::string("\0\1\2", 3), ""), "format is not known"));
    EXPECT_TRUE(says(refusal("   \n", ""), "format is not known"));
}

TEST(ReadMesh, UnderstandsAnyLineEnd) {
    for (const std::string end : {"\r\n", "\r", " \t \n", "\n\n"}) {
        expectTwoSquares(replaced(twoObj(), "\n", end), "a.obj");
        expectTwoSquares(replaced(twoOff(), "\n", end), "a.off");
        if (end != "\n\n") expectTwoSquares(replaced(twoPly(), "\n", end), "a.ply");
    }
}

TEST(ReadMesh, UnderstandsSeveralLineEndsInOneFile) {
    // Each takes turns, as in files that were put together or edited on several systems.
    const auto mixed = [](const std::string& text, const std::vector<std::string>& ends) {
        std::string result;
        for (std::size_t count = 0; const char c : text)
            result += c == '\n' ? ends[count++ % ends.size()] : std::string(1, c);
        return result;
    };
    for (const std::vector<std::string>& ends :
         {std::vector<std::string>{"\n", "\r"}, {"\r", "\n"}, {"\r\n", "\r"}, {"\r", "\r\n"}, {"\r\r\n"}}) {
        expectTwoSquares(mixed(twoObj(), ends), "a.obj");
        expectTwoSquares(mixed(twoOff(), ends), "a.off");
        expectTwoSquares(mixed(twoPly(), ends), "a.ply");
    }
    EXPECT_TRUE(says(refusal("# 1\n# 2\r# 3\r\nv 1 x 0\r", "a.obj"), "^line 4: "));
}

TEST(ReadMesh, NeedsNoFinalLineEnd) {
    expectTwoSquares(twoObj().substr(0, twoObj().size() - 1), "a.obj");
    expectTwoSquares(twoOff().substr(0, twoOff().size() - 1), "a.off");
    expectTwoSquares(twoPly().substr(0, twoPly().size() - 1), "a.ply");
}

TEST(ReadMesh, SkipsTheByteOrderMark) {
    expectTwoSquares("\xEF\xBB\xBF" + twoObj(), "a.obj");
    expectTwoSquares("\xEF\xBB\xBF" + twoOff(), "a.off");
    expectTwoSquares("\xEF\xBB\xBF" + twoPly(), "a.ply");
}

TEST(ReadMesh, AllowsTabsAndIndents) {
    expectTwoSquares(replaced(replaced(twoObj(), " ", "\t \v"), "\n", "\n  "), "a.obj");
    expectTwoSquares(replaced(replaced(twoOff(), " ", "\t\f"), "\n", "\n\t"), "a.off");
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
    const QuadMesh mesh =
        read("v 9 9 9\n" + replaced(twoObj(), "f 1 2 3 4\nf 2 5 6 3", "f 2 3 4 5"), "a.obj");
    EXPECT_EQ(mesh.n_vertices(), 7U);
    EXPECT_TRUE(mesh.is_isolated(VertexId(0)));
}

TEST(ReadMesh, AcceptsTwoQuadsBackToBack) {
    const QuadMesh mesh = read(replaced(twoObj(), "f 2 5 6 3", "f 4 3 2 1"), "a.obj");
    EXPECT_EQ(mesh.n_edges(), 4U);
}

// ---------------------------------------------------------------------------- what is no oriented manifold

std::string objOf(const std::string& vertices, const std::string& faces) {
    return vertices + faces;
}

/// Vertices 1 to 12 of a 4 x 3 grid of vertices.
constexpr const char* gridPoints = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n"
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
        "^face 1 (line 14): it has 3 sides; 3 of 5 faces are not four-sided. Make quads of all faces: "
        "quadmesh"));
    EXPECT_TRUE(says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8\n"), "a.obj"),
                     "1 of 3 faces is not four-sided. Make quads of all faces: quadmesh --subdivide"));
    EXPECT_TRUE(
        says(refusal(objOf(gridPoints, "f\n"), "a.obj"),
             "^face 0 (line 13): it has 0 sides. Use another copy of the file, or take the face out"));
}

TEST(Refusal, OfIndicesOutOfRange) {
    EXPECT_TRUE(
        says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 2 3 7 13\n"), "a.obj"),
             "^face 1 (line 14): vertex index 13 is out of range: there are 12 vertices, counted from 1"));
    EXPECT_TRUE(says(refusal(objOf(gridPoints, "f -1 -2 -3 -13\n"), "a.obj"),
                     "^line 13: face 0: vertex index -13 is out of range: there are 12 vertices before it"));
    // Indices from 2 on are no sign that a file counts from another number.
    EXPECT_TRUE(says(refusal(objOf(gridPoints, "f 2 3 7 13\n"), "a.obj"), "correct the index"));
    EXPECT_TRUE(says(refusal("f 1 2 3 4\n", "a.obj"), "there are 0 vertices"));
}

TEST(Refusal, OfPlacesThatAreNone) {
    for (const std::string word : {"nan", "NaN", "-nan", "nan(ind)"})
        EXPECT_TRUE(says(refusal(replaced(twoObj(), "v 2 1 0", "v 2 " + word + " 0"), "a.obj"),
                         "^vertex 5 (line 6): a coordinate is not a number"));
    for (const std::string word : {"inf", "-inf", "Infinity", "1e999", "-1e400", "1e99999999999"})
        EXPECT_TRUE(says(refusal(replaced(twoObj(), "v 2 1 0", "v 2 " + word + " 0"), "a.obj"),
                         "^vertex 5 (line 6): a coordinate is infinite"));
    EXPECT_TRUE(says(refusal(replaced(twoObj(), "v 2 1 0", "v 2 1e200 0"), "a.obj"), "larger than 1e150"));
    EXPECT_TRUE(says(refusal(replaced(twoPly(), "2 1 0\n", "2 nan 0\n"), "a.ply"),
                     "^vertex 5 (line 16): a coordinate is not"));
    EXPECT_TRUE(says(refusal(replaced(twoOff(), "2 1 0\n", "2 inf 0\n"), "a.off"),
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
    // The reversed quad is a duplicate, too, as soon as it has neighbours.
    EXPECT_TRUE(
        says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 2 3 7 6\nf 5 6 2 1\n"), "a.obj"), "same vertices"));
    EXPECT_TRUE(says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 1 2 6 5\n"), "a.obj"), "same vertices"));
}

TEST(Refusal, OfACrowdedEdge) {
    EXPECT_TRUE(says(
        refusal(objOf(std::string(gridPoints) + "v 1 0 1\nv 1 1 1\n", "f 1 2 6 5\nf 2 3 7 6\nf 2 6 14 13\n"),
                "a.obj"),
        "^edge between vertices 1 and 5: 3 faces meet there: face 0 (line 15), face 1 (line 16), "
        "face 2 (line 17). The surface is no manifold there: take out faces that are too many, such as a "
        "rib"));
}

TEST(Refusal, OfInconsistentOrientation) {
    EXPECT_TRUE(says(refusal(objOf(gridPoints, "f 1 2 6 5\nf 2 3 7 6\nf 3 7 8 4\n"), "a.obj"),
                     "^edge between vertices 2 and 6: face 1 (line 14) and face 2 (line 15) are "
                     "oriented inconsistently, as at 1 edge in all",
                     "--repair orients them"));
}

/// A ring of squares, whose ends are joined with a half turn if it is to be one-sided.
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
    EXPECT_EQ(warningsOf(twoObj()), std::vector<std::string>());
}

TEST(Warnings, AboutCoincidentVertices) {
    EXPECT_TRUE(says(onlyOne(warningsOf(twoObj() + "v 2 1 0\nv -0 0 0\n")),
                     "2 of 8 vertices lie where another does"));
}

TEST(Warnings, NameTheRepairOfSeamsAloneAsItClosesNothingElse) {
    const auto beside = [](const std::string& points) {
        return onlyOne(
            warningsOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + points + "f 1 2 3 4\nf 5 6 7 8\n"));
    };
    EXPECT_TRUE(says(beside("v 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\n"), "2 of 8 vertices lie where another does",
                     "If a seam should be closed, use --repair"));
    EXPECT_TRUE(
        says(beside("v 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n"),
             "1 of 8 vertices lies where another does: vertex 4 where 2. The surface touches itself there"));
    EXPECT_TRUE(says(beside("v 1 1 0\nv 2 0 0\nv 1 0 0\nv 0 0 1\n"), "lie where another does",
                     "The surface touches itself there"))
        << "two vertices that one surface has an edge between, the other none";
}

TEST(Warnings, AboutQuadsWithoutArea) {
    EXPECT_TRUE(says(onlyOne(warningsOf("v 0 0 0\nv 1 0 0\nv 3 0 0\nv 2 0 0\nf 1 2 3 4\n")),
                     "1 of 1 quads has no area"));
}

/// Three by three quads in a plane, of which two vertices have changed places.
std::string plateObj(int one, int other) {
    std::string text;
    for (int k = 0; k < 16; ++k) {
        const int at = k == one ? other : k == other ? one : k;
        text += "v " + std::to_string(at % 4) + " " + std::to_string(at / 4) + " 0\n";
    }
    for (int j = 0; j < 3; ++j)
        for (int i = 1 + 4 * j; i < 4 + 4 * j; ++i)
            text += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 5) +
                    " " + std::to_string(i + 4) + "\n";
    return text;
}

TEST(Warnings, AboutQuadsThatLieUpsideDown) {
    EXPECT_TRUE(says(onlyOne(warningsOf(plateObj(5, 10))),
                     "1 of 9 quads lies upside down on others, the first "
                     "is face 4"));
    EXPECT_EQ(warningsOf(plateObj(5, 5)), std::vector<std::string>());
    // A sheet that is folded in the middle has two sides.
    EXPECT_EQ(warningsOf("v 0 0 0\nv 1 0 0\nv 0 0 0.1\nv 0 1 0\nv 1 1 0\nv 0 1 0.1\n"
                         "f 1 2 5 4\nf 2 3 6 5\n"),
              std::vector<std::string>());
}

TEST(Warnings, AboutManyComponents) {
    std::string text;
    for (int k = 0; k < 11; ++k)
        text += replaced("v X 0 0\nv X 1 0\nv X 1 1\nv X 0 1\nf -4 -3 -2 -1\n", "X", std::to_string(k));
    EXPECT_TRUE(says(onlyOne(warningsOf(text)), "the mesh has 11 components"));
    std::string lonely = twoObj();
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
        test::expectConsistent(mesh);
    }
}

TEST(BuiltMesh, HandlesAVertexOfHighValence) {
    // A fan of 100,000 quads: a walk around the vertex for each of them would take minutes.
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
    const auto names = test::sharedFiles("dev");
    if (names.empty()) GTEST_SKIP() << "no shared meshes";
    for (const std::string& name : names) {
        SCOPED_TRACE(name);
        EXPECT_NO_THROW(test::expectConsistent(read(*test::sharedFile(name), name)));
    }
}

TEST(SharedMeshes, OfBadAreRefusedForTheRightReason) {
    if (test::sharedFiles("bad").empty()) GTEST_SKIP() << "no shared meshes";
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
        {"truncated.obj", "face 130 (line 1180): the last line ends after 1 corner"},
    };
    for (const auto& [name, reason] : reasons)
        EXPECT_TRUE(says(refusal(*test::sharedFile("bad/" + name), name), reason)) << name;
}

TEST(SharedMeshes, WithUnusualSyntaxAreTheSame) {
    const auto plain = test::sharedFile("dev/fandisk_qex.obj");
    if (!plain) GTEST_SKIP() << "no shared meshes";
    const QuadMesh expected = read(*plain, "a.obj"),
                   found = read(*test::sharedFile("dev/awkward_valid.obj"), "a.obj");
    EXPECT_LT(test::largestDistance(found, expected), 1e-5); // its file has fewer digits
    EXPECT_EQ(facesOf(found), facesOf(expected));
}

// ------------------------------------------------------------------------------------------ mutated files

/// Changes a few places of a text: bytes, numbers, lines, the length.
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
        default: // copies a piece to another place
            text.insert(at, text.substr(below(text.size() + 1), below(60)));
        }
    }
    return text;
}

TEST(MutatedFiles, AreRefusedOrValid) {
    std::mt19937_64 engine(7);
    const std::string cube = writeObj(makeShape("cube", {.resolution = 2}));
    std::vector<std::pair<std::string, std::string>> originals{
        {twoObj(), "a.obj"}, {cube, "a.obj"}, {twoOff(), "a.off"}, {twoPly(), "a.ply"}};
    for (const bool little : {true, false})
        originals.emplace_back(binaryPly(little, "float", "int", little), "a.ply");
    std::size_t valid = 0, refused = 0;
    for (int round = 0; round < 1000; ++round)
        for (const auto& [text, name] : originals)
            for (const bool repair : {false, true}) {
                const std::string bytes = mutated(text, engine);
                try {
                    test::expectConsistent(readMesh(bytes, name, {repair}).mesh);
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
