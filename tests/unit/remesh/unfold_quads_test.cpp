#include "remesh/unfold_quads.h"
#include "shape/scan.h"
#include "shape/shape.h"
#include "support/grid_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace qm {
namespace {

constexpr double farAway = 10;

TEST(Uprightness, IsOneForSquaresOnAPlaneAndNegativeForTheirBack) {
    const TriangleSurface plane({{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}}});
    const auto of = [&](const std::vector<Point>& corners) {
        QuadMesh mesh;
        std::vector<VertexId> vertices;
        for (const Point& corner : corners)
            vertices.push_back(mesh.add_vertex(corner));
        return uprightness(mesh, mesh.add_face(vertices), plane, farAway);
    };
    EXPECT_NEAR(of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), 1, 1e-12);
    EXPECT_NEAR(of({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}), -1, 1e-12);
    EXPECT_NEAR(of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}), 0, 1e-12) << "a corner of 180 degrees";
    EXPECT_LT(of({{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}}), 0) << "a corner beyond 180 degrees";
    EXPECT_LT(of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), 0) << "a bow tie";
    EXPECT_EQ(of({{1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}}), -1) << "a point";
}

TEST(Uprightness, OfAQuadAcrossASharpEdgeGoesByTheMeanNormal) {
    QuadMesh mesh; // across the upper edge of a cube at y = 0
    std::vector<VertexId> vertices;
    for (const Point& corner : std::vector<Point>{{0.4, 0.1, 1}, {0.4, 0, 0.9}, {0.6, 0, 0.9}, {0.6, 0.1, 1}})
        vertices.push_back(mesh.add_vertex(corner));
    const FaceId face = mesh.add_face(vertices);
    const TriangleSurface cube(makeScan("cube", 2000));
    EXPECT_GT(uprightness(mesh, face, cube, farAway), 0.7);
    EXPECT_LE(uprightness(mesh, face, cube, farAway), 1);
}

/// A plane net of 7 x 7 vertices, counted row by row.
QuadMesh net() {
    return test::makeMesh({6, 6, [](double i, double j) { return Point(i, j, 0); }});
}

TriangleSurface planeOfNet() {
    return TriangleSurface({{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}}, {{0, 1, 2}, {0, 2, 3}}});
}

double minUprightness(const QuadMesh& mesh, const TriangleSurface& scan) {
    double worst = 1;
    for (const FaceId face : mesh.faces())
        worst = std::min(worst, uprightness(mesh, face, scan, farAway));
    return worst;
}

TEST(UnfoldQuads, VerticesPulledOverTheirNeighboursGoBack) {
    QuadMesh mesh = net();
    const TriangleSurface scan = planeOfNet();
    mesh.set_point(VertexId(24), {5.4, 4.3, 0});
    mesh.set_point(VertexId(17), {0.7, 4.6, 0});
    ASSERT_LT(minUprightness(mesh, scan), 0);
    unfoldQuads(mesh, scan, farAway);
    EXPECT_GT(minUprightness(mesh, scan), 0.2);
}

TEST(UnfoldQuads, VerticesOfTheBoundaryStayOnIt) {
    QuadMesh mesh = net();
    const TriangleSurface scan = planeOfNet();
    mesh.set_point(VertexId(3), {4.6, 0, 0}); // beyond its neighbour
    ASSERT_LT(minUprightness(mesh, scan), 0);
    unfoldQuads(mesh, scan, farAway);
    EXPECT_GT(minUprightness(mesh, scan), 0.2);
    for (const VertexId vertex : mesh.vertices())
        if (mesh.is_boundary(vertex)) {
            const Point& point = mesh.point(vertex);
            EXPECT_TRUE(point[0] == 0 || point[0] == 6 || point[1] == 0 || point[1] == 6) << point;
        }
}

TEST(UnfoldQuads, UprightQuadsStayWhereTheyAre) {
    for (const char* part : {"cube", "sphere", "bracket"}) {
        const QuadMesh before = makeShape(part, {.resolution = 6});
        QuadMesh mesh = before;
        unfoldQuads(mesh, TriangleSurface(makeScan(part, 5000)), farAway);
        for (const VertexId vertex : mesh.vertices())
            EXPECT_EQ(mesh.point(vertex), before.point(vertex)) << part;
    }
}

TEST(UnfoldQuads, NothingMovesWhereTheScanIsFarAway) {
    QuadMesh mesh = net();
    mesh.set_point(VertexId(24), {5.4, 4.3, 0});
    const Point before = mesh.point(VertexId(24));
    unfoldQuads(mesh, TriangleSurface({{{0, 0, 9}, {6, 0, 9}, {6, 6, 9}}, {{0, 1, 2}}}), 1);
    EXPECT_EQ(mesh.point(VertexId(24)), before);
}

} // namespace
} // namespace qm
