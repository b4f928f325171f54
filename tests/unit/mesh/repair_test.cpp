#include "base/at.h"
#include "mesh/boundary_loops.h"
#include "mesh/files/read_mesh.h"
#include "mesh/files/write_soup.h"
#include "mesh/soup/repair.h"
#include "mesh/suspicions.h"
#include "mesh/topology.h"
#include "shape/shape.h"
#include "support/mesh_text.h"
#include "support/message_of.h"
#include "support/shared_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace qm {
namespace {

using test::FaceIndices;
using test::facesOf;
using test::pointsOf;

ReadResult repaired(const std::string& obj) {
    ReadResult result = readMesh(obj, "a.obj", {.repair = true});
    test::expectConsistent(result.mesh);
    return result;
}

std::string refusal(const std::string& obj) {
    return test::messageOf([&] { (void)readMesh(obj, "a.obj", {.repair = true}); });
}

void expectReport(const RepairReport& report, std::size_t welded, std::size_t degenerate,
                  std::size_t duplicate, std::size_t flipped) {
    EXPECT_EQ(report.weldedVertices, welded);
    EXPECT_EQ(report.degenerateFaces, degenerate);
    EXPECT_EQ(report.duplicateFaces, duplicate);
    EXPECT_EQ(report.flippedFaces, flipped);
    EXPECT_EQ(report.changed(), welded + degenerate + duplicate + flipped > 0);
}

/// A mesh in which every quad has four vertices of its own.
/// \param shake  largest random shift of a coordinate
std::string unwelded(const QuadMesh& mesh, double shake = 0) {
    std::mt19937 engine(3);
    QuadMesh result;
    std::string text;
    for (const auto& face : facesOf(mesh)) {
        for (const int corner : face) {
            const Point& point = mesh.point(VertexId(corner));
            text += 'v';
            for (const double value : point) {
                const double random =
                    static_cast<double>(engine()) / static_cast<double>(std::mt19937::max());
                char number[40];
                (void)std::snprintf(number, sizeof number, " %.17g", value + shake * (2 * random - 1));
                text += number;
            }
            text += '\n';
        }
        text += "f -4 -3 -2 -1\n";
    }
    return text;
}

std::string scaled(const QuadMesh& mesh, double factor) {
    QuadMesh result = mesh;
    for (const VertexId vertex : result.vertices())
        result.set_point(vertex, result.point(vertex) * factor);
    return writeObj(result);
}

/// Compares edges, extraordinary vertices and components, which welding must restore.
void expectSameShape(const QuadMesh& found, const QuadMesh& expected) {
    EXPECT_EQ(found.n_vertices(), expected.n_vertices());
    EXPECT_EQ(found.n_edges(), expected.n_edges());
    EXPECT_EQ(found.n_faces(), expected.n_faces());
    EXPECT_EQ(extraordinaryVertices(found).size(), extraordinaryVertices(expected).size());
    EXPECT_EQ(components(found).count, components(expected).count);
}

TEST(Repair, LeavesValidMeshesAlone) {
    for (const ShapeKind& kind : shapeKinds()) {
        const QuadMesh mesh = makeShape(kind.name, {.resolution = 2});
        const ReadResult result = repaired(writeObj(mesh));
        expectReport(result.repair, 0, 0, 0, 0);
        EXPECT_EQ(pointsOf(result.mesh), pointsOf(mesh));
        EXPECT_EQ(facesOf(result.mesh), facesOf(mesh));
    }
}

TEST(Repair, WeldsASoup) {
    for (const ShapeKind& kind : shapeKinds()) {
        SCOPED_TRACE(kind.name);
        const QuadMesh mesh = makeShape(kind.name, {.resolution = 3});
        const ReadResult result = repaired(unwelded(mesh));
        expectReport(result.repair, 4 * mesh.n_faces() - mesh.n_vertices(), 0, 0, 0);
        expectSameShape(result.mesh, mesh);
    }
}

TEST(Repair, WeldsWhatDiffersByRounding) {
    const QuadMesh mesh = makeShape("block", {.resolution = 4});
    expectSameShape(repaired(unwelded(mesh, 1e-10)).mesh, mesh); // the block is three units wide
    EXPECT_EQ(repaired(unwelded(mesh, 1e-6)).repair.weldedVertices, 0U);
}

TEST(Repair, WeldsInAnyUnit) {
    const QuadMesh mesh = makeShape("sphere", {.resolution = 3});
    for (const double factor : {1e-300, 1e-100, 1e-9, 1e9, 1e100}) {
        SCOPED_TRACE(factor);
        const QuadMesh small = readMesh(scaled(mesh, factor), "a.obj").mesh;
        expectSameShape(repaired(unwelded(small)).mesh, mesh);
    }
}

TEST(Repair, WeldsFarFromTheOrigin) {
    QuadMesh mesh = makeShape("cube", {.resolution = 2});
    for (const VertexId vertex : mesh.vertices())
        mesh.set_point(vertex, mesh.point(vertex) + Point(1e12, -1e15, 1e6));
    expectSameShape(repaired(unwelded(mesh)).mesh, mesh);
}

TEST(Repair, KeepsTheOrderOfVertices) {
    // A second square has its own copies of the shared vertices; an isolated vertex between them stays.
    const ReadResult result = repaired("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0\n"
                                       "v 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 1 2 3 4\nf 6 7 8 9\n");
    expectReport(result.repair, 2, 0, 0, 0);
    EXPECT_EQ(
        pointsOf(result.mesh),
        (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}}));
    EXPECT_EQ(facesOf(result.mesh), (std::vector<FaceIndices>{{0, 1, 2, 3}, {1, 5, 6, 2}}));
}

TEST(Repair, WeldsNoInteriorVertices) {
    // Two spheres that touch in a point, where welding would make a vertex with two fans.
    QuadMesh mesh = makeShape("cube", {.resolution = 2});
    std::string text = writeObj(mesh);
    const auto count = mesh.n_vertices();
    for (const VertexId vertex : mesh.vertices())
        mesh.set_point(vertex, mesh.point(vertex) + Point(1, 1, 1));
    const std::string second = writeObj(mesh);
    text += second.substr(0, second.find('f'));
    for (const auto& face : facesOf(mesh)) {
        text += 'f';
        for (const int corner : face)
            text += ' ' + std::to_string(static_cast<std::size_t>(corner) + 1 + count);
        text += '\n';
    }
    const ReadResult result = repaired(text);
    expectReport(result.repair, 0, 0, 0, 0);
    const std::vector<std::string> warnings = suspicions(result.mesh);
    ASSERT_FALSE(warnings.empty());
    EXPECT_TRUE(warnings.front().starts_with("1 of 52 vertices lies where another does"));
    EXPECT_EQ(warnings.front().find("--repair"), std::string::npos); // which does not change it
}

TEST(Repair, WeldsNoEndsOfASide) {
    const ReadResult result = repaired("v 0 0 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    expectReport(result.repair, 0, 0, 0, 0);
    EXPECT_EQ(result.mesh.n_vertices(), 4U);
}

TEST(Repair, RefusesToCrowdAnEdge) {
    // Three squares like the pages of a book. The message uses the numbers of the file, although two earlier
    // vertices are dropped.
    const std::string message =
        refusal("v 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\nv 6 0 0\nv 7 0 0\nv 7 1 0\nv 6 1 0\n"
                "v 0 0 0\nv 0 1 0\nv -1 1 0\nv -1 0 0\n"
                "v 0 0 0\nv 0 1 0\nv 1 1 0\nv 1 0 0\n"
                "v 0 0 0\nv 0 1 0\nv 0 1 1\nv 0 0 1\n"
                "f 1 2 3 4\nf 5 6 7 8\nf 9 10 11 12\nf 13 14 15 16\nf 17 18 19 20\n");
    EXPECT_TRUE(message.starts_with("edge between vertices 8 and 9: 3 faces meet there: face 2 (line 23)"))
        << message;
}

TEST(Repair, CollapsesAQuadWithoutInside) {
    // A grid of 4 x 4 squares in which one square's opposite corners meet.
    std::string text;
    for (int j = 0; j <= 4; ++j)
        for (int i = 0; i <= 4; ++i) {
            const bool meets = (i == 1 && j == 1) || (i == 2 && j == 2);
            text += meets ? "v 1.5 1.5 0\n" : "v " + std::to_string(i) + " " + std::to_string(j) + " 0\n";
        }
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const int a = 5 * j + i + 1;
            text += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(a + 6) +
                    " " + std::to_string(a + 5) + "\n";
        }
    const ReadResult result = repaired(text);
    expectReport(result.repair, 1, 1, 0, 0);
    EXPECT_EQ(result.mesh.n_faces(), 15U);
    EXPECT_EQ(components(result.mesh).count, 1);
    const auto euler = static_cast<long>(result.mesh.n_vertices()) -
                       static_cast<long>(result.mesh.n_edges()) + static_cast<long>(result.mesh.n_faces());
    EXPECT_EQ(euler, 1);
    EXPECT_EQ(extraordinaryVertices(result.mesh).size(), 3U); // six edges in the middle, three beside it
}

TEST(Repair, DropsDegenerateFaces) {
    const QuadMesh mesh = makeShape("cube", {.resolution = 2});
    const ReadResult result = repaired(writeObj(mesh) + "f 1 2 2 3\nf 4 5 4 6\nf 7 7 7 7\n");
    expectReport(result.repair, 0, 3, 0, 0);
    EXPECT_EQ(facesOf(result.mesh), facesOf(mesh));
}

TEST(Repair, LeavesAHoleWhereAFaceWasDegenerate) {
    std::string text = writeObj(makeShape("cube", {.resolution = 2}));
    const std::size_t line = text.rfind("\nf ") + 1;
    text.replace(line, std::string::npos, "f 1 1 2 3\n");
    const ReadResult result = repaired(text);
    expectReport(result.repair, 0, 1, 0, 0);
    EXPECT_EQ(result.mesh.n_faces(), 23U);
}

TEST(Repair, DropsDuplicateFaces) {
    const QuadMesh mesh = makeShape("cube", {.resolution = 2});
    std::string text = writeObj(mesh);
    const auto face = facesOf(mesh)[5];
    const auto word = [&](int k) { return " " + std::to_string(face[at(k)] + 1); };
    text += "f" + word(1) + word(2) + word(3) + word(0) + "\n"; // the same face, turned
    text += "f" + word(3) + word(2) + word(1) + word(0) + "\n"; // the same face, reversed
    const ReadResult result = repaired(text);
    expectReport(result.repair, 0, 0, 2, 0);
    EXPECT_EQ(facesOf(result.mesh), facesOf(mesh));
}

TEST(Repair, DropsDuplicatesThatWeldingMakes) {
    const QuadMesh mesh = makeShape("block", {.resolution = 1});
    const ReadResult result = repaired(unwelded(mesh) + unwelded(mesh));
    expectReport(result.repair, 8 * mesh.n_faces() - mesh.n_vertices(), 0, mesh.n_faces(), 0);
    expectSameShape(result.mesh, mesh);
}

/// Reverses some faces of a mesh and keeps their first vertices; returns OBJ text.
std::string flipped(const QuadMesh& mesh, const std::vector<bool>& which) {
    const std::string text = writeObj(mesh);
    std::string result = text.substr(0, text.find('f'));
    const auto faces = facesOf(mesh);
    for (std::size_t k = 0; k < faces.size(); ++k) {
        auto face = faces[k];
        if (which[k]) std::swap(face[1], face[3]);
        result += 'f';
        for (const int corner : face)
            result += ' ' + std::to_string(corner + 1);
        result += '\n';
    }
    return result;
}

TEST(Repair, OrientsAsMostFacesAre) {
    std::mt19937 engine(1);
    for (const ShapeKind& kind : shapeKinds()) {
        SCOPED_TRACE(kind.name);
        const QuadMesh mesh = makeShape(kind.name, {.resolution = 3});
        if (components(mesh).count > 1) continue;
        std::vector<bool> which(mesh.n_faces());
        std::generate(which.begin(), which.end(), [&] { return engine() % 5 == 0; });
        const ReadResult result = repaired(flipped(mesh, which));
        expectReport(result.repair, 0, 0, 0, static_cast<std::size_t>(std::ranges::count(which, true)));
        EXPECT_EQ(facesOf(result.mesh), facesOf(mesh));
    }
}

TEST(Repair, OrientsEveryComponentByItself) {
    // In the first component most faces are reversed, in the second few.
    const std::string points = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n";
    const std::string more = "v 0 0 9\nv 1 0 9\nv 2 0 9\nv 3 0 9\nv 0 1 9\nv 1 1 9\nv 2 1 9\nv 3 1 9\n";
    const ReadResult result = repaired(points + more +
                                       "f 1 5 6 2\nf 2 3 7 6\nf 3 7 8 4\n"
                                       "f 9 10 14 13\nf 10 14 15 11\nf 11 12 16 15\n");
    expectReport(result.repair, 0, 0, 0, 2);
    EXPECT_EQ(facesOf(result.mesh)[1], (FaceIndices{1, 5, 6, 2}));
    EXPECT_EQ(facesOf(result.mesh)[4], (FaceIndices{9, 10, 14, 13}));
}

TEST(Repair, KeepsTheFirstFaceInATie) {
    const ReadResult result =
        repaired("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 5 6 3\n");
    EXPECT_EQ(facesOf(result.mesh), (std::vector<FaceIndices>{{0, 1, 4, 3}, {1, 2, 5, 4}}));
}

TEST(Repair, RefusesWhatCannotBeMended) {
    EXPECT_EQ(refusal("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\n").substr(0, 15), "face 0 (line 5)");
    EXPECT_NE(refusal("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 nan 0\nf 1 2 3 4\n").find("not a number"),
              std::string::npos);
    EXPECT_NE(refusal("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3 4\n").find("out of range"), std::string::npos);
    EXPECT_NE(refusal("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3 3\n").find("no face is left"), std::string::npos);
}

TEST(Repair, RefusesASurfaceWithOneSide) {
    std::string text;
    for (int k = 0; k < 5; ++k)
        text += "v " + std::to_string(k) + " 0 0\nv " + std::to_string(k) + " 1 0\n";
    text += "f 1 3 4 2\nf 3 5 6 4\nf 5 7 8 6\nf 7 9 10 8\nf 9 2 1 10\n";
    EXPECT_NE(refusal(text).find("one side only"), std::string::npos) << refusal(text);
}

TEST(Repair, IsQuickOnVerticesInOnePlace) {
    // All vertices in one point, which would slow down a search that is not linear.
    std::string text;
    for (int k = 0; k < 20'000; ++k)
        text += "v 1 1 1\nv 1 1 1\nv 1 1 1\nv 1 1 1\nf -4 -3 -2 -1\n";
    EXPECT_FALSE(refusal(text).empty());
}

TEST(Repair, OfSharedMeshes) {
    const auto fandisk = test::sharedFile("dev/fandisk_qex.obj");
    if (!fandisk) GTEST_SKIP() << "no shared meshes";
    const QuadMesh expected = readMesh(*fandisk, "a.obj").mesh;

    const ReadResult welded = repaired(*test::sharedFile("dev/unwelded.obj"));
    expectReport(welded.repair, 2689, 0, 0, 0);
    expectSameShape(welded.mesh, expected);

    const ReadResult turned = repaired(*test::sharedFile("bad/flipped_faces.obj"));
    EXPECT_LT(test::largestDistance(turned.mesh, expected), 1e-5); // its file has fewer digits
    auto cyclic = [](const QuadMesh& mesh) {
        auto faces = facesOf(mesh);
        for (auto& face : faces)
            std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        return faces;
    };
    EXPECT_EQ(cyclic(turned.mesh), cyclic(expected));

    const ReadResult holes = repaired(*test::sharedFile("bad/repeated_vertex_face.obj"));
    expectReport(holes.repair, 0, 2, 0, 0);
    EXPECT_EQ(holes.mesh.n_faces(), 895U);

    expectReport(repaired(*test::sharedFile("bad/gmsh_nut.obj")).repair, 0, 0, 0, 12);
    expectReport(repaired(*test::sharedFile("dev/bearing_plate_qf_5k.obj")).repair, 1, 1, 0, 0);
    const ReadResult apart = repaired(*test::sharedFile("bad/rockerarm_nonmanifold.obj"));
    EXPECT_EQ(apart.repair.splitVertices, 7U);
    EXPECT_EQ(apart.mesh.n_faces(), 1490U);
    EXPECT_NE(refusal(*test::sharedFile("bad/moebius.obj")).find("one side only"), std::string::npos);
}

TEST(Repair, OfDamagedMeshesIsValidOrRefused) {
    // Random identifications, copies and reversals in a small mesh.
    std::mt19937 engine(11);
    const QuadMesh mesh = makeShape("cube", {.resolution = 2});
    std::size_t valid = 0;
    for (int round = 0; round < 3000; ++round) {
        auto faces = facesOf(mesh);
        for (unsigned change = engine() % 4; change > 0; --change) {
            auto& face = faces[engine() % faces.size()];
            switch (engine() % 4) {
            case 0:
                std::swap(face[1], face[3]);
                break;
            case 1:
                face[engine() % 4] = static_cast<int>(engine() % mesh.n_vertices());
                break;
            case 2:
                faces.push_back(face);
                break;
            default:
                face = faces.back();
                faces.pop_back();
            }
        }
        std::string text = writeObj(mesh);
        text.resize(text.find('f'));
        for (const auto& face : faces) {
            text += 'f';
            for (const int corner : face)
                text += ' ' + std::to_string(corner + 1);
            text += '\n';
        }
        if (refusal(text).empty()) {
            const ReadResult result = repaired(text);
            // A repaired mesh needs no further repair.
            EXPECT_FALSE(readMesh(writeObj(result.mesh), "a.obj", {.repair = true}).repair.changed());
            ++valid;
        }
    }
    EXPECT_GT(valid, 500U);
}

TEST(Repair, SplitsVerticesWhereSeveralFansMeet) {
    // Two squares that touch at vertex 3 (the third point), and a third one that also touches there.
    const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n"
                             "v 0 1 1\nv 0 2 1\nv 1 2 1\nf 1 2 3 4\nf 3 5 6 7\nf 3 10 9 8\n";
    const std::string problem = test::messageOf([&] { (void)readMesh(text, "touching.obj"); });
    EXPECT_NE(problem.find("vertex 2 (line 3): the faces around it fall into several fans. The surface "
                           "is no manifold there. The option --repair splits the vertex"),
              std::string::npos)
        << problem;
    const ReadResult read = readMesh(text, "touching.obj", {.repair = true});
    EXPECT_EQ(read.repair.splitVertices, 1U);
    EXPECT_EQ(read.mesh.n_vertices(), 12U);
    EXPECT_EQ(read.mesh.n_faces(), 3U);
    for (const int copy : {10, 11})
        EXPECT_EQ(read.mesh.point(VertexId(copy)), read.mesh.point(VertexId(2)));
}

/// The surface of unit cubes at whole coordinates, which share the corners in which they touch.
std::string surfaceOfCubes(const std::set<std::array<int, 3>>& cubes) {
    std::map<std::array<int, 3>, std::size_t> vertices; // numbers from 1
    std::string points, faces;
    for (const auto& cube : cubes)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) {
                auto beyond = cube;
                beyond[axis] += 2 * side - 1;
                if (cubes.contains(beyond)) continue;
                faces += 'f';
                for (const auto& [a, b] :
                     {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}}) {
                    auto corner = cube;
                    corner[axis] += side;
                    corner[(axis + 1) % 3] += side == 1 ? a : b;
                    corner[(axis + 2) % 3] += side == 1 ? b : a;
                    const auto [vertex, isNew] = vertices.emplace(corner, vertices.size() + 1);
                    if (isNew)
                        points += "v " + std::to_string(corner[0]) + ' ' + std::to_string(corner[1]) + ' ' +
                                  std::to_string(corner[2]) + '\n';
                    faces += ' ' + std::to_string(vertex->second);
                }
                faces += '\n';
            }
    return points + faces;
}

TEST(Repair, TakesSolidsApartThatTouchAtAnEdge) {
    const std::string text = surfaceOfCubes({{0, 0, 0}, {1, 1, 0}});
    const std::string problem = test::messageOf([&] { (void)readMesh(text, "a.obj"); });
    EXPECT_NE(problem.find("4 faces meet there"), std::string::npos) << problem;
    EXPECT_NE(problem.find("--repair takes solids apart that touch"), std::string::npos) << problem;
    const ReadResult read = repaired(text);
    EXPECT_EQ(read.repair.splitVertices, 2U);
    EXPECT_EQ(read.mesh.n_vertices(), 16U);
    EXPECT_EQ(components(read.mesh).count, 2U);
    const auto warnings = suspicions(read.mesh);
    ASSERT_FALSE(warnings.empty());
    EXPECT_TRUE(warnings.front().ends_with("The surface touches itself there")) << warnings.front();
}

TEST(Repair, TakesASolidApartThatTouchesItself) {
    // Cubes at two ends of a diagonal on a plate: above its lower end, the edge divides one fan into two.
    const ReadResult read =
        repaired(surfaceOfCubes({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 1, 1}}));
    EXPECT_EQ(read.repair.splitVertices, 1U);
    EXPECT_EQ(components(read.mesh).count, 1U);
}

TEST(Repair, DividesWhatIsOutsideWhereASolidCannotBeTakenApart) {
    // As before, with another plate above: the edge ends inside of one fan at either end.
    std::set<std::array<int, 3>> cubes{{0, 0, 1}, {1, 1, 1}};
    for (const int height : {0, 2})
        cubes.insert({{0, 0, height}, {0, 1, height}, {1, 0, height}, {1, 1, height}});
    const ReadResult read = repaired(surfaceOfCubes(cubes));
    EXPECT_EQ(read.repair.splitVertices, 2U);
    EXPECT_EQ(components(read.mesh).count, 1U);
}

TEST(Repair, TakesAnySetOfCubesApart) {
    std::mt19937 engine(7);
    for (int round = 0; round < 200; ++round) {
        std::set<std::array<int, 3>> cubes;
        for (int k = 0; k < 20; ++k) {
            const auto coordinate = [&] { return static_cast<int>(engine() % 4); };
            cubes.insert({coordinate(), coordinate(), coordinate()});
        }
        const std::string text = surfaceOfCubes(cubes);
        const ReadResult read = repaired(text);
        EXPECT_EQ(boundaryLoops(read.mesh).size(), 0U);
        EXPECT_EQ(read.mesh.n_faces(), static_cast<std::size_t>(std::ranges::count(text, 'f')));
        EXPECT_FALSE(readMesh(writeObj(read.mesh), "a.obj", {.repair = true}).repair.changed());
    }
}

} // namespace
} // namespace qm
