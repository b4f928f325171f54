#include "base/at.h"
#include "mesh/dihedral.h"
#include "mesh/files/read_mesh.h"
#include "mesh/quad_geometry.h"
#include "mesh/soup/build_mesh.h"
#include "shape/shape.h"
#include "support/shared_files.h"
#include "support/steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

constexpr double pi = std::numbers::pi;

/// Two squares that meet at an angle along the y axis; at angle 0 they are flat.
QuadMesh hinge(double angle, double size = 1) {
    const double c = size * std::cos(angle), s = size * std::sin(angle);
    return buildMesh({{0, 0, 0}, {0, size, 0}, {-size, size, 0}, {-size, 0, 0}, {c, 0, s}, {c, size, s}},
                     {{0, 1, 2, 3}, {1, 0, 4, 5}});
}

double angleOfHinge(const QuadMesh& mesh) {
    const HalfedgeId halfedge = mesh.find_halfedge(VertexId(0), VertexId(1));
    return dihedralAngles(mesh)[at(mesh.edge_handle(halfedge))];
}

TEST(Dihedral, IsTheAngleBetweenTheFacesWhicheverWayTheyTurn) {
    for (const double angle : test::steps(0, 3.1, 0.1)) {
        EXPECT_NEAR(angleOfHinge(hinge(angle)), angle, 1e-12);
        EXPECT_NEAR(angleOfHinge(hinge(-angle)), angle, 1e-12);
    }
    EXPECT_NEAR(angleOfHinge(hinge(pi - 1e-9)), pi - 1e-9, 1e-12); // exact, unlike a cosine
    EXPECT_NEAR(angleOfHinge(hinge(1e-9)), 1e-9, 1e-15);
}

TEST(Dihedral, DoesNotDependOnTheUnit) {
    for (const double size : {1e-200, 1e-100, 1e-9, 1e-3, 1e3, 1e100})
        EXPECT_NEAR(angleOfHinge(hinge(0.7, size)), 0.7, 1e-12) << size;
}

TEST(Dihedral, IsZeroOnTheBoundary) {
    const QuadMesh mesh = hinge(1);
    const std::vector<double> angles = dihedralAngles(mesh);
    EXPECT_EQ(std::ranges::count_if(angles, [](double angle) { return angle != 0; }), 1);
}

TEST(Dihedral, OfACubeIsARightAngle) {
    for (const int resolution : {1, 3})
        for (const double angle : dihedralAngles(makeShape("cube", {.resolution = resolution})))
            EXPECT_TRUE(angle < 1e-12 || std::abs(angle - pi / 2) < 1e-12) << angle;
}

TEST(Dihedral, OfABentQuadUsesBothTriangles) {
    // The normal of (0,0,0) (1,0,0) (1,1,1) (0,1,0): triangles (0,-1,1)/sqrt2 and (-1,0,1)/sqrt2.
    const QuadMesh mesh = buildMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}, {{0, 1, 2, 3}});
    const Point normal = quadNormal(mesh, FaceId(0)).value();
    const double length = std::sqrt(6.0);
    EXPECT_NEAR(normal[0], -1 / length, 1e-15);
    EXPECT_NEAR(normal[1], -1 / length, 1e-15);
    EXPECT_NEAR(normal[2], 2 / length, 1e-15);
}

TEST(Dihedral, SplitsAtTheFirstVertexOfTheFile) {
    // From the next corner, the quad is split along its other diagonal, where the triangles' normals differ.
    const QuadMesh mesh = buildMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}, {{1, 2, 3, 0}});
    const auto [first, second] = halvesOf(mesh, FaceId(0));
    EXPECT_NEAR((triangleNormal(first).value() - Point(-1, -1, 1) / std::sqrt(3.0)).norm(), 0, 1e-15);
    EXPECT_NEAR((triangleNormal(second).value() - Point(0, 0, 1)).norm(), 0, 1e-15);
    EXPECT_EQ(cornersOf(mesh, FaceId(0))[0], VertexId(1));
}

TEST(Dihedral, TakesTheOtherTriangleWhereOneHasNoArea) {
    const QuadMesh mesh = buildMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
    EXPECT_EQ(quadNormal(mesh, FaceId(0)), Point(0, 0, 1));
    EXPECT_TRUE(hasArea(mesh, FaceId(0)));
}

TEST(Dihedral, IsZeroBesideAFaceWithoutNormal) {
    // The second quad has no area.
    const QuadMesh mesh = buildMesh({{0, 0, 0}, {0, 1, 0}, {-1, 1, 1}, {-1, 0, 1}, {0, 2, 0}, {0, 3, 0}},
                                    {{0, 1, 2, 3}, {1, 0, 4, 5}});
    EXPECT_FALSE(hasArea(mesh, FaceId(1)));
    EXPECT_EQ(quadNormal(mesh, FaceId(1)), std::nullopt);
    for (const double angle : dihedralAngles(mesh))
        EXPECT_EQ(angle, 0);
}

TEST(EdgeCosts, PenaliseFlatEdges) {
    const std::vector<double> costs = edgeCosts({0, 0.19, 0.2, 1.5}, {.alpha = 0.4, .epsilon = 0.2});
    EXPECT_DOUBLE_EQ(costs[0], 0.4);
    EXPECT_DOUBLE_EQ(costs[1], 0.21);
    EXPECT_DOUBLE_EQ(costs[2], -0.2); // not below epsilon
    EXPECT_DOUBLE_EQ(costs[3], -1.5);
    EXPECT_DOUBLE_EQ(edgeCosts({0.5}, {.alpha = 0, .epsilon = 1})[0], -0.5);
}

TEST(EdgeCosts, OfACubeAddUpToTwelveRightAngles) {
    double sum = 0;
    for (const double cost : edgeCosts(dihedralAngles(makeShape("cube", {.resolution = 1})), {}))
        sum += cost;
    EXPECT_NEAR(sum, -12 * pi / 2, 1e-9);
}

TEST(EdgeCosts, OfASkewedCubeKnownFromElsewhere) {
    const auto bytes = test::sharedFile("dev/cube6.off");
    if (!bytes) GTEST_SKIP() << "no shared meshes";
    double sum = 0;
    for (const double cost : edgeCosts(dihedralAngles(readMesh(*bytes, "cube6.off").mesh), {}))
        sum += cost;
    EXPECT_NEAR(sum, -18.849556, 1e-6); // all edges are tracks there
}

} // namespace
} // namespace qm
