#include "base/error.h"
#include "mesh/files/read_triangles.h"
#include "mesh/files/write_soup.h"
#include "shape/shape.h"
#include "support/mesh_text.h"
#include "support/message_of.h"

#include <gtest/gtest.h>

#include <random>

namespace qm {
namespace {

constexpr const char* facet = "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n      vertex 1 0 0\n"
                              "      vertex 1 1 0\n    endloop\n  endfacet\n";
constexpr const char* otherFacet =
    "FACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 -0 VERTEX 1 1 0 VERTEX 0 1 0 ENDLOOP "
    "ENDFACET\n";
std::string textStl() {
    return std::string("solid two of them\n") + facet + otherFacet + "endsolid two of them\n";
}

void expectRefused(const std::string& bytes, const std::string& name, const std::string& part) {
    const std::string message = test::messageOf([&] { (void)readTriangles(bytes, name); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line";
    EXPECT_NE(message.find(part), std::string::npos) << message << " of:\n" << bytes.substr(0, 300);
}

Triangles square() {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

void expectSquare(const std::string& bytes, const std::string& name) {
    SCOPED_TRACE(name);
    const Triangles triangles = readTriangles(bytes, name);
    EXPECT_EQ(triangles.points, square().points);
    EXPECT_EQ(triangles.faces, square().faces);
}

TEST(ReadTriangles, StripsOfAPlyTurnEverySecondTriangle) {
    const std::string header = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                               "property float z\nelement tristrips 1\n";
    const std::string list = "property list int int vertex_indices\n";
    const std::string body = "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 1 0\n8 0 1 2 3 -1 3 1 4\n";
    const Triangles triangles = readTriangles(header + list + body, "a.ply");
    const std::vector<std::array<int, 3>> expected{{0, 1, 2}, {2, 1, 3}, {3, 1, 4}};
    EXPECT_EQ(triangles.faces, expected);
    EXPECT_EQ(triangles.points.size(), 5U);
    expectRefused(header + body, "a.ply", "the strips do not have one list vertex_indices each");
    expectRefused(header + list + body.substr(0, body.size() - 3), "a.ply", "the file ends there");
}

TEST(ReadTriangles, TextStlInSmallAndCapitalLettersIsWeldedIntoOneSurface) {
    expectSquare(textStl(), "a.stl");
    expectSquare(textStl(), "no-ending");
    expectSquare(std::string("solid one\n") + facet + "endsolid\nsolid\n" + otherFacet + "endsolid\n",
                 "a.stl");
}

TEST(ReadTriangles, EveryFormatThatIsWrittenIsRead) {
    for (const auto& [format, name] :
         {std::pair(MeshFormat::obj, "a.obj"), std::pair(MeshFormat::off, "a.off"),
          std::pair(MeshFormat::ply, "a.ply"), std::pair(MeshFormat::stl, "a.stl")})
        expectSquare(writeSoup(soupOf(square()), format), name);
}

TEST(ReadTriangles, PolygonsBecomeFans) {
    expectSquare("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "a.obj");
    EXPECT_EQ(readTriangles(writeSoup(soupOf(makeShape("cube")), MeshFormat::ply), "a.ply").faces.size(),
              2 * makeShape("cube").n_faces());
}

TEST(ReadTriangles, AFinalTriangleNeedsNoLineEnd) {
    expectSquare("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4", "a.obj");
    expectRefused("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2", "a.obj", "cut off");
}

TEST(ReadTriangles, TrianglesWithAPointTwiceAndUnusedPointsAreLeftOut) {
    expectSquare("v 7 7 7\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nf 2 3 4\nf 3 6 4\nf 2 4 5\n",
                 "a.obj");
    expectRefused("v 0 0 0\nv 0 0 0\nv 1 0 0\nf 1 2 3\n", "a.obj", "three different corners");
}

TEST(ReadTriangles, BinaryStlMayBeginWithSolid) {
    std::string bytes = writeSoup(soupOf(square()), MeshFormat::stl);
    bytes.replace(0, 5, "solid");
    expectSquare(bytes, "a.stl");
}

TEST(ReadTriangles, AByteOrderMarkIsPassedOverWhereItIsNoPartOfABinaryHeader) {
    const std::string mark = "\xEF\xBB\xBF";
    expectSquare(mark + textStl(), "a.stl");
    std::string bytes = writeSoup(soupOf(square()), MeshFormat::stl);
    bytes.replace(0, 3, mark);
    expectSquare(bytes, "a.stl");
}

TEST(ReadTriangles, WhatIsNotWholeOrNoSurfaceIsRefused) {
    const std::string binary = writeSoup(soupOf(square()), MeshFormat::stl);
    expectRefused(binary.substr(0, binary.size() - 1), "a.stl", "2 facets that its header announces");
    expectRefused(binary + "x", "a.stl", "Use a complete copy");
    expectRefused(binary.substr(0, 60), "a.stl", "within its header");
    expectRefused(textStl().substr(0, 100), "a.stl",
                  "line 6: expected vertex or endloop, found \"ve\". The file seems to be cut off");
    expectRefused(std::string("solid\n") + facet, "a.stl", "endsolid, but the file ends");
    expectRefused("solid\nfacet normal 0 0 1\nouter loop\nvertex 1 x 2\n", "a.stl", "found \"x\"");
    expectRefused("solid\nendsolid\n", "a.stl", "no faces");
    expectRefused("solid\nfacet normal 0 0 1\nouter loop\nvertex 1 0 2\nendloop\nendfacet\nendsolid", "a.stl",
                  "face 0 (line 3): it has 1 side");
    expectRefused("v 0 0 0\nv 1 0 0\nv 1 1 0\n", "a.obj", "no faces");
    expectRefused("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 2 3 3 9\n", "a.obj",
                  "face 1 (line 5): vertex index 9");
    expectRefused("v 0 0 0\nv 1 0 nan\nv 1 1 0\nf 1 2 3\n", "a.obj", "not a number");
    expectRefused("", "a.stl", "empty");
    expectRefused("hello", "", "OBJ, OFF, PLY or STL");
}

TEST(ReadTriangles, AnyBytesAreReadOrRefused) {
    std::mt19937 random(5);
    const std::vector<std::pair<std::string, std::string>> files{
        {textStl(), "a.stl"},
        {writeSoup(soupOf(square()), MeshFormat::stl), "a.stl"},
        {writeSoup(soupOf(square()), MeshFormat::ply), "a.ply"},
        {writeSoup(soupOf(square()), MeshFormat::obj), "a.obj"}};
    int refused = 0;
    for (int round = 0; round < 4000; ++round) {
        auto [bytes, name] = files[random() % files.size()];
        for (auto changes = 1 + random() % 3; changes > 0; --changes) {
            const std::size_t place = random() % bytes.size();
            if (random() % 4 == 0) bytes.resize(place + 1);
            bytes[place] = static_cast<char>(random() % 2 == 0 ? random() % 256 : '0' + random() % 10);
        }
        try {
            const Triangles triangles = readTriangles(bytes, name);
            for (const auto& face : triangles.faces)
                for (const int corner : face)
                    ASSERT_LT(static_cast<std::size_t>(corner), triangles.points.size());
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(refused, 4000);
}

} // namespace
} // namespace qm
