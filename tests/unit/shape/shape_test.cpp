#include "base/at.h"
#include "base/error.h"
#include "mesh/dihedral.h"
#include "mesh/files/write_soup.h"
#include "mesh/soup/build_mesh.h"
#include "mesh/suspicions.h"
#include "mesh/topology.h"
#include "shape/quad_list.h"
#include "shape/round_hole.h"
#include "shape/scan.h"
#include "shape/shape.h"
#include "shape/voxels.h"
#include "support/mesh_text.h"
#include "support/steps.h"
#include "support/true_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace qm {
namespace {

int eulerNumber(const QuadMesh& mesh) {
    return static_cast<int>(mesh.n_vertices()) - static_cast<int>(mesh.n_edges()) +
           static_cast<int>(mesh.n_faces());
}

bool isClosed(const QuadMesh& mesh) {
    return std::none_of(mesh.edges_begin(), mesh.edges_end(),
                        [&](EdgeId edge) { return mesh.is_boundary(edge); });
}

/// The enclosed volume by the divergence theorem; positive if faces are counter-clockwise seen from outside.
double volume(const QuadMesh& mesh) {
    double six = 0;
    for (const auto& face : test::facesOf(mesh)) {
        const auto at = [&](std::size_t k) { return mesh.point(VertexId(face[k])); };
        six += at(0) | (at(1) % at(2));
        six += at(0) | (at(2) % at(3));
    }
    return six / 6;
}

struct Expected {
    int euler;
    bool closed;
    std::size_t extraordinary;
};
std::map<std::string, Expected> expectedShapes() {
    return {{"block", {0, true, 16}},   {"bracket", {-2, true, 28}}, {"cube", {2, true, 8}},
            {"cylinder", {2, true, 8}}, {"genus2", {-2, true, 24}},  {"genus3", {-4, true, 32}},
            {"helix", {0, true, 8}},    {"plate", {0, false, 4}},    {"sphere", {2, true, 8}},
            {"torus", {0, true, 0}},    {"tube", {0, false, 0}}};
}

TEST(Shapes, HaveTheTopologyTheyClaim) {
    for (const auto& [name, shape] : expectedShapes())
        for (const int resolution : {1, 2, 3, 5, 8}) {
            SCOPED_TRACE(name + " " + std::to_string(resolution));
            const QuadMesh mesh = makeShape(name, {.resolution = resolution});
            test::expectConsistent(mesh);
            EXPECT_EQ(eulerNumber(mesh), shape.euler);
            EXPECT_EQ(isClosed(mesh), shape.closed);
            EXPECT_EQ(extraordinaryVertices(mesh).size(), shape.extraordinary);
            EXPECT_EQ(components(mesh).count, 1);
        }
}

TEST(Shapes, AreAllListedOnceInOrder) {
    std::vector<std::string> names;
    for (const ShapeKind& kind : shapeKinds())
        names.emplace_back(kind.name);
    EXPECT_TRUE(std::ranges::is_sorted(names));
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
    EXPECT_EQ(names.size(), expectedShapes().size() + 2); // and two random shapes
}

TEST(Shapes, RaiseNoSuspicion) {
    for (const ShapeKind& kind : shapeKinds())
        EXPECT_EQ(suspicions(makeShape(kind.name)), std::vector<std::string>()) << kind.name;
}

TEST(Shapes, AreSeenFromOutside) {
    for (const ShapeKind& kind : shapeKinds()) {
        const QuadMesh mesh = makeShape(kind.name);
        if (isClosed(mesh)) {
            EXPECT_GT(volume(mesh), 0) << kind.name;
        }
    }
    const QuadMesh plate = makeShape("plate");
    for (const FaceId face : plate.faces())
        EXPECT_GT(plate.calc_face_normal(face)[2], 0.99);
    const QuadMesh tube = makeShape("tube");
    for (const FaceId face : tube.faces()) {
        const Point centre = tube.calc_face_centroid(face);
        EXPECT_GT(tube.calc_face_normal(face) | Point(centre[0], centre[1], 0), 0);
    }
}

TEST(Shapes, HaveTheVolumeTheyShould) {
    constexpr double pi = std::numbers::pi;
    EXPECT_NEAR(volume(makeShape("cube")), 1, 1e-12);
    EXPECT_NEAR(volume(makeShape("sphere", {.resolution = 40})), 4 * pi / 3, 0.005);
    EXPECT_NEAR(volume(makeShape("torus", {.resolution = 20})), 2 * pi * pi * 3, 0.2);
    EXPECT_NEAR(volume(makeShape("genus3", {.resolution = 20})), 27 - 3 * pi * 0.75 * 0.75, 0.02);
    // The volume that a fillet of radius f removes around a bore of radius r: two rings, by Pappus's theorem.
    const double r = 0.6, f = 0.35, corner = f * f * (1 - pi / 4), centre = f * (10 - 3 * pi) / (12 - 3 * pi);
    const double rims = 2 * 2 * pi * corner * (r + f - (f - centre));
    const double block = volume(makeShape("block", {.resolution = 40}));
    EXPECT_LT(block, 18 - 2 * pi * r * r);
    EXPECT_NEAR(block, 18 - 2 * pi * r * r - rims, 0.1);
}

TEST(Shapes, BlockIsSharpOutsideAndSoftInside) {
    const QuadMesh mesh = makeShape("block", {.resolution = 8});
    const std::vector<double> angles = dihedralAngles(mesh);
    for (const EdgeId edge : mesh.edges()) {
        const double angle = angles[at(edge)];
        const Point middle = mesh.calc_edge_midpoint(edge);
        int extremes = 0; // number of the block's six sides that contain the edge
        for (const unsigned axis : {0U, 1U, 2U})
            if (middle[axis] < 1e-9 || middle[axis] > (axis == 2 ? 2 : 3) - 1e-9) ++extremes;
        if (extremes >= 2) {
            EXPECT_NEAR(angle, std::numbers::pi / 2, 1e-9);
        } else {
            EXPECT_LT(angle, 0.5);
        }
    }
}

TEST(Shapes, SphereIsRound) {
    const QuadMesh mesh = makeShape("sphere");
    for (const VertexId vertex : mesh.vertices())
        EXPECT_NEAR(mesh.point(vertex).norm(), 1, 1e-15);
}

TEST(Shapes, HelixHasThreadsThatWindManyTimes) {
    // On the ring without boss, a single line along the rows passes through all vertices.
    const QuadMesh mesh = makeShape("helix", {.resolution = 3});
    std::size_t longest = 0;
    for (const VertexId start : extraordinaryVertices(mesh))
        for (const HalfedgeId first : mesh.voh_range(start)) {
            std::size_t length = 1;
            HalfedgeId halfedge = first;
            while (continuesStraight(mesh, mesh.to_vertex_handle(halfedge))) {
                halfedge = straightOn(mesh, halfedge);
                ++length;
            }
            longest = std::max(longest, length);
        }
    EXPECT_GT(longest, 3U * 36U) << "more than three times around";
}

TEST(Shapes, CanHaveAHundredThousandQuads) {
    EXPECT_EQ(makeShape("block", {.resolution = 46}).n_faces(), 48U * 46 * 46);
}

TEST(Shapes, RefuseWhatTheyCannotMake) {
    EXPECT_THROW((void)makeShape("teapot"), Error);
    EXPECT_THROW((void)makeShape(""), Error);
    EXPECT_THROW((void)makeShape("block", {.resolution = -1}), Error);
    EXPECT_THROW((void)makeShape("cube", {.resolution = 2'000'000'000}), Error);
    EXPECT_THROW((void)makeShape("torus", {.resolution = 500}), Error);
    EXPECT_THROW((void)makeShape("random", {.voxels = 0}), Error);
    EXPECT_THROW((void)makeShape("random", {.voxels = 1'000'000'000}), Error);
}

TEST(Shapes, HaveAsManyQuadsAroundAsAskedFor) {
    for (const char* name : {"cylinder", "sphere", "torus", "tube"})
        for (const int around : {4, 6, 10, 30, 34}) {
            SCOPED_TRACE(name + std::to_string(around));
            const QuadMesh mesh = makeShape(name, {.around = around});
            test::expectConsistent(mesh);
            EXPECT_EQ(extraordinaryVertices(mesh).size(), expectedShapes().at(name).extraordinary);
            const auto surface = test::trueSurface(name);
            int onCircle = 0; // vertices on the circle in which a plane cuts the part
            for (const VertexId vertex : mesh.vertices()) {
                const Point& point = mesh.point(vertex);
                EXPECT_LT(surface->nearest(point).distance, 1e-14);
                const bool ring = std::string(name) == "torus";
                if (ring ? std::abs(point[1]) < 1e-9 && point[0] > 0
                         : std::abs(point[2]) < 1e-9 && std::hypot(point[0], point[1]) > 1 - 1e-9)
                    ++onCircle;
            }
            // The sphere has no vertices on the equator if an odd number of rows lies beside it.
            if (std::string(name) != "sphere" || around / 4 % 2 == 0) {
                EXPECT_EQ(onCircle, around);
            }
        }
    EXPECT_THROW((void)makeShape("block", {.around = 30}), Error);
    EXPECT_THROW((void)makeShape("sphere", {.around = 31}), Error);
    EXPECT_THROW((void)makeShape("torus", {.around = 3}), Error);
    EXPECT_THROW((void)makeShape("torus", {.around = 100'000}), Error);
}

TEST(TrueSurfaces, HoldAllVerticesOfTheirParts) {
    int parts = 0;
    for (const ShapeKind& kind : shapeKinds()) {
        const auto surface = test::trueSurface(kind.name);
        if (!surface) continue;
        ++parts;
        for (const int resolution : {1, 5}) {
            const QuadMesh mesh = makeShape(kind.name, {.resolution = resolution});
            for (const VertexId vertex : mesh.vertices())
                EXPECT_LT(surface->nearest(mesh.point(vertex)).distance, 1e-14) << kind.name;
        }
    }
    EXPECT_EQ(parts, 8);
}

TEST(TrueSurfaces, AreTheLimitOfFineMeshes) {
    // Inside faces, the distance of a mesh from the surface falls with the square of its edges; the normals
    // are those of the mesh's faces.
    for (const ShapeKind& kind : shapeKinds()) {
        const auto surface = test::trueSurface(kind.name);
        if (!surface) continue;
        SCOPED_TRACE(kind.name);
        const auto error = [&](int resolution) {
            const QuadMesh mesh = makeShape(kind.name, {.resolution = resolution});
            double largest = 0;
            for (const FaceId face : mesh.faces()) {
                const auto nearest = surface->nearest(mesh.calc_face_centroid(face));
                largest = std::max(largest, nearest.distance);
                EXPECT_GT(nearest.normal | mesh.calc_face_normal(face), 0.8);
                EXPECT_NEAR(nearest.normal.norm(), 1, 1e-12);
            }
            return largest;
        };
        EXPECT_LT(error(24), error(6) / 12 + 1e-12);
    }
}

TEST(TrueSurfaces, HaveDistancesThatAreKnown) {
    const auto distance = [](const char* name, const Point& point) {
        return test::trueSurface(name)->nearest(point).distance;
    };
    EXPECT_NEAR(distance("sphere", {0, 0, 0}), 1, 1e-15);
    EXPECT_NEAR(distance("sphere", {0, 0, -3}), 2, 1e-15);
    EXPECT_NEAR(distance("torus", {0, 0, 0}), 2, 1e-15);
    EXPECT_NEAR(distance("torus", {3, 0, 0.25}), 0.75, 1e-15);
    EXPECT_NEAR(distance("tube", {0, 0, 9}), std::hypot(1, 3), 1e-15);
    EXPECT_NEAR(distance("cylinder", {0, 0, 2.75}), 0.25, 1e-15);
    EXPECT_NEAR(distance("cylinder", {4, 0, 7}), 5, 1e-15);
    EXPECT_NEAR(distance("cube", {2, 2, 0.5}), std::sqrt(2), 1e-15);
    EXPECT_NEAR(distance("block", {1.5, 1.5, 1}), 0.6, 1e-15) << "in the middle of the hole";
    EXPECT_NEAR(distance("block", {1.5, 1.5, 3}), std::hypot(0.95, 1.35) - 0.35, 1e-15) << "above it";
    EXPECT_NEAR(distance("genus3", {4.5, 1.5, 0.5}), 0.75, 1e-15);
    EXPECT_NEAR(distance("plate", {2.5, 1.6, 0}), 0.2, 1e-15);
    EXPECT_FALSE(test::trueSurface("random"));
}

TEST(Scans, HaveAboutAsManyTrianglesAsAskedFor) {
    for (const ShapeKind& kind : shapeKinds())
        for (const double wanted : {5000.0, 20'000.0}) {
            const auto found = static_cast<double>(makeScan(kind.name, wanted).faces.size());
            EXPECT_NEAR(found / wanted, 1, 0.2) << kind.name;
        }
    EXPECT_THROW((void)makeScan("cube", 0), Error);
    EXPECT_THROW((void)makeScan("cube", 1e9), Error);
    EXPECT_THROW((void)makeScan("teapot", 1000), Error);
}

TEST(Scans, HaveNormallyDistributedNoiseThatDependsOnTheSeedAlone) {
    const Triangles clean = makeScan("sphere", 100'000);
    Triangles noisy = clean;
    addNoise(noisy, 0.01, 1);
    double sum = 0;
    double squares = 0;
    double within = 0;
    for (const Point& point : noisy.points) {
        const double height = point.norm() - 1;
        sum += height;
        squares += height * height;
        within += std::abs(height) < 0.01 ? 1 : 0;
    }
    const auto count = static_cast<double>(noisy.points.size());
    EXPECT_NEAR(sum / count, 0, 3e-4);
    EXPECT_NEAR(std::sqrt(squares / count), 0.01, 3e-4);
    EXPECT_NEAR(within / count, 0.683, 0.01);
    Triangles again = clean;
    addNoise(again, 0.01, 1);
    EXPECT_EQ(again.points, noisy.points);
    again = clean;
    addNoise(again, 0.01, 2);
    EXPECT_NE(again.points, noisy.points);
}

TEST(RandomShapes, AreManifoldsForEverySeed) {
    std::set<int> eulerNumbers;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        const QuadMesh closed = makeShape("random", {.resolution = 2, .seed = seed, .voxels = 60});
        test::expectConsistent(closed);
        EXPECT_TRUE(isClosed(closed));
        EXPECT_GT(volume(closed), 30);
        eulerNumbers.insert(eulerNumber(closed));
        const QuadMesh open = makeShape("random-open", {.resolution = 2, .seed = seed, .voxels = 60});
        test::expectConsistent(open);
        EXPECT_FALSE(isClosed(open));
        EXPECT_LT(open.n_faces(), closed.n_faces());
    }
    EXPECT_GT(eulerNumbers.size(), 1U) << "some have holes";
}

TEST(RandomShapes, DependOnTheSeedAlone) {
    const auto text = [](std::uint64_t seed) { return writeObj(makeShape("random", {.seed = seed})); };
    EXPECT_EQ(text(5), text(5));
    EXPECT_NE(text(5), text(6));
}

TEST(RandomShapes, OfOneVoxelAreCubes) {
    EXPECT_EQ(makeShape("random", {.resolution = 1, .voxels = 1}).n_faces(), 6U);
}

TEST(VoxelSurface, OfABoxIsClosedAndOutward) {
    const QuadList list = voxelSurface(voxelBox(2, 3, 4));
    const QuadMesh mesh = buildMesh(list.points, list.quads);
    EXPECT_EQ(mesh.n_faces(), 2U * (6 + 8 + 12));
    EXPECT_NEAR(volume(mesh), 24, 1e-12);
}

TEST(VoxelSurface, KnowsWhereItIsNoManifold) {
    EXPECT_TRUE(surfaceIsManifoldAt({{0, 0, 0}, {1, 0, 0}}, {0, 0, 0}));
    EXPECT_FALSE(surfaceIsManifoldAt({{0, 0, 0}, {1, 1, 0}}, {0, 0, 0})); // only a common edge
    EXPECT_FALSE(surfaceIsManifoldAt({{0, 0, 0}, {1, 1, 1}}, {0, 0, 0})); // only a common corner
    EXPECT_TRUE(surfaceIsManifoldAt({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {0, 0, 0}));
    // A 2 x 2 x 2 block without two opposite voxels, so that the outside is pinched at the middle.
    Voxels pinched = voxelBox(2, 2, 2);
    pinched.erase({0, 0, 0});
    pinched.erase({1, 1, 1});
    EXPECT_FALSE(surfaceIsManifoldAt(pinched, {0, 1, 0}));
}

TEST(Refined, DividesEveryQuad) {
    const QuadList cube = voxelSurface(voxelBox(1, 1, 1));
    for (const int n : {1, 2, 5}) {
        const QuadList fine = refined(cube, n);
        EXPECT_EQ(fine.quads.size(), static_cast<std::size_t>(6 * n * n));
        EXPECT_EQ(fine.points.size(), static_cast<std::size_t>(6 * n * n + 2));
        const QuadMesh mesh = buildMesh(fine.points, fine.quads);
        EXPECT_NEAR(volume(mesh), 1, 1e-12);
    }
}

TEST(Soften, KeepsTheVolumeAndRoundsEdges) {
    QuadList cube = refined(voxelSurface(voxelBox(1, 1, 1)), 8);
    soften(cube, 40);
    const QuadMesh mesh = buildMesh(cube.points, cube.quads);
    EXPECT_NEAR(volume(mesh), 1, 0.1);
    EXPECT_LT(std::ranges::max(dihedralAngles(mesh)), 1);
}

TEST(GridTopologies, CloseAsTheySay) {
    const GridTopology torus{.columns = 5, .rows = 4, .columnsClosed = true, .rowsClosed = true, .shift = 2};
    EXPECT_EQ(torus.vertex(5, 0), torus.vertex(0, 0));
    EXPECT_EQ(torus.vertex(1, 4), torus.vertex(3, 0));
    EXPECT_EQ(torus.quads().size(), 20U);
    EXPECT_EQ(torus.width() * torus.height(), 20);
    const GridTopology sheet{.columns = 5, .rows = 4};
    EXPECT_EQ(sheet.width() * sheet.height(), 30);
}

TEST(RoundHoles, MapSquaresToCirclesAndLeaveTheOutside) {
    const RoundHole hole{.hole = 0.5, .frame = 1.5, .radius = 0.7};
    for (const double t : test::steps(-1, 1, 0.125)) {
        const auto rim = hole.moved({0.5, 0.5 * t});
        EXPECT_NEAR(std::hypot(rim.x, rim.y), 0.7, 1e-12);
        EXPECT_NEAR(std::atan2(rim.y, rim.x), t * std::numbers::pi / 4, 1e-12);
        const auto lower = hole.moved({0.5 * t, -0.5});
        EXPECT_NEAR(std::hypot(lower.x, lower.y), 0.7, 1e-12);
        const auto outside = hole.moved({1.5, 1.5 * t});
        EXPECT_NEAR(outside.x, 1.5, 1e-12);
        EXPECT_NEAR(outside.y, 1.5 * t, 1e-12);
    }
    EXPECT_EQ(hole.moved({2, 7}).y, 7);
}

} // namespace
} // namespace qm
