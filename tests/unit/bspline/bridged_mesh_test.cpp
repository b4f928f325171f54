#include "base/positions.h"
#include "bspline/fit.h"
#include "bspline/reference/improvement/bridged_mesh.h"
#include "mesh/dihedral.h"
#include "mesh/quad_geometry.h"
#include "support/grid_layout.h"
#include "support/limit_sample.h"
#include "support/star_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace qm {
namespace {

using test::Grid;
using test::noCreases;

constexpr int folded = 3; // both coordinates of the folded vertex, in eight columns and seven rows

VertexId vertexAt(int i, int j) {
    return VertexId(j * 9 + i);
}

/// A sheet in which one vertex is at the place of other parameters.
Grid sheet(double i, double j, const std::function<Point(double, double)>& place) {
    return {8, 7, [=](double u, double v) { return u == folded && v == folded ? place(i, j) : place(u, v); }};
}

Point inPlane(double i, double j) {
    return {i, j, 2};
}

Point onCylinder(double i, double j) {
    constexpr double radius = 5;
    return {i, radius * std::sin(j / radius), radius * std::cos(j / radius)};
}

Point overRoof(double i, double j) {
    return {i, j, -2 * std::max(0.0, j - folded)};
}

/// A disk of quads around one vertex whose other angles are 120 degrees, or a little less.
QuadMesh fan(int quads) {
    QuadMesh mesh = test::star(quads);
    const double half = std::numbers::pi / quads;
    for (int k = 1 + quads; k <= 2 * quads; ++k)
        mesh.set_point(VertexId(k), (std::cos(half) + std::sin(half) / std::sqrt(3)) *
                                        mesh.point(VertexId(k)).normalized());
    return mesh;
}

/// A plane cap of triangles around one vertex, each divided into three quads, and the wall below it.
QuadMesh drum(int triangles) {
    return test::dividedFan(triangles, 0, {{{1.0 / 2, 0}, {2.0 / 3, 0}, {1, 0}, {1, -0.5}}});
}

std::size_t foldedQuads(const QuadMesh& mesh) {
    return countWhere(mesh.faces(), [&](FaceId face) { return isFolded(mesh, face); });
}

TEST(IsFolded, WhereACornerIsFlatOrTurnedOrWithoutArea) {
    const auto count = [](double i, double j) { return foldedQuads(test::makeMesh(sheet(i, j, inPlane))); };
    EXPECT_EQ(count(3, 3), 0U);
    EXPECT_EQ(count(3.3, 2.6), 0U);
    EXPECT_EQ(count(3.5, 3.5), 1U) << "three corners in a line";
    EXPECT_EQ(count(3.8, 3.8), 1U);
    EXPECT_EQ(count(4, 3), 2U) << "two vertices in one place";
    EXPECT_EQ(count(4.5, 3), 2U) << "those on the other side are only wide";
}

TEST(IsFolded, NotWhereManyEdgesLeaveNarrowAngles) {
    const auto count = [](int quads, double secondEdge) {
        QuadMesh mesh = fan(quads);
        // Turns every second edge, so that quads are narrow and wide in turn.
        const double angle = secondEdge * 2 * std::numbers::pi / quads;
        for (int k = 2; k <= quads; k += 2) {
            const Point point = mesh.point(VertexId(k));
            mesh.set_point(VertexId(k), {point[0] * std::cos(angle) - point[1] * std::sin(angle),
                                         point[0] * std::sin(angle) + point[1] * std::cos(angle), 0});
        }
        return foldedQuads(mesh);
    };
    EXPECT_EQ(count(20, 0), 0U);
    EXPECT_EQ(count(100, 0), 0U);
    EXPECT_EQ(count(1000, 0), 0U);
    EXPECT_EQ(count(100, 0.3), 0U);
    EXPECT_EQ(count(100, 0.9), 50U) << "far narrower than a regular spread has them";
}

TEST(BridgedMesh, MovesNothingWhereNothingIsFolded) {
    const QuadMesh mesh = test::makeMesh(sheet(3.3, 2.6, inPlane));
    EXPECT_FALSE(bridgedMesh(mesh, noCreases(mesh)));
}

TEST(BridgedMesh, MakesFoldedQuadsUprightAndKeepsThePlane) {
    for (const double i : {3.5, 4.0, 4.5, 5.2}) {
        const QuadMesh mesh = test::makeMesh(sheet(i, i == 3.5 ? 3.5 : 3, inPlane));
        ASSERT_GT(foldedQuads(mesh), 0U);
        const auto bridged = bridgedMesh(mesh, noCreases(mesh));
        ASSERT_TRUE(bridged) << i;
        EXPECT_EQ(foldedQuads(*bridged), 0U) << i;
        EXPECT_LT((bridged->point(vertexAt(folded, folded)) - inPlane(folded, folded)).norm(), 0.3) << i;
        for (const VertexId vertex : bridged->vertices()) {
            EXPECT_NEAR(bridged->point(vertex)[2], 2, 1e-12);
            if (!mesh.is_boundary(vertex)) continue;
            EXPECT_EQ(bridged->point(vertex), mesh.point(vertex));
        }
    }
}

TEST(BridgedMesh, ContinuesTheSurfaceAround) {
    const QuadMesh mesh = test::makeMesh(sheet(3.6, 3.6, onCylinder));
    const auto bridged = bridgedMesh(mesh, noCreases(mesh));
    ASSERT_TRUE(bridged);
    for (const VertexId vertex : bridged->vertices()) {
        const Point point = bridged->point(vertex);
        EXPECT_NEAR(std::hypot(point[1], point[2]), 5, 0.002);
    }
}

TEST(BridgedMesh, LeavesCreasesAndWhatHidesThem) {
    // The folded vertex lies on a ridge; the creases beside its quads may be due to the fold.
    const QuadMesh mesh = test::makeMesh(sheet(4.5, 3, overRoof));
    std::vector<bool> isCrease;
    for (const double angle : dihedralAngles(mesh))
        isCrease.push_back(angle > 0.45);
    EXPECT_FALSE(bridgedMesh(mesh, isCrease));
}

TEST(BridgedMesh, LeavesTheOutlinesOfPlaneQuadsWithFlatCorners) {
    // Three corners are nearly in a line in every quad along the edge of the cap, but the normals of these
    // quads are beyond doubt, and so is the crease.
    constexpr int triangles = 110;
    const QuadMesh mesh = drum(triangles);
    ASSERT_EQ(foldedQuads(mesh), static_cast<std::size_t>(2 * triangles));
    std::vector<bool> isCrease;
    for (const double angle : dihedralAngles(mesh))
        isCrease.push_back(angle > 0.45);
    const QuadMesh bridged = bridgedMesh(mesh, isCrease).value_or(mesh);
    for (const VertexId vertex : mesh.vertices()) {
        EXPECT_NEAR(bridged.point(vertex)[2], mesh.point(vertex)[2], 1e-12);
        if (std::abs(mesh.point(vertex).norm() - 1) > 1e-12) continue;
        EXPECT_EQ(bridged.point(vertex), mesh.point(vertex));
    }
}

TEST(BridgedMesh, SurfacesDoNotFoldWhereTheMeshDoes) {
    const Grid grid = sheet(4.4, 3.3, onCylinder);
    const QuadMesh mesh = test::makeMesh(grid);
    const Layout layout = test::makeLayout(grid, {{0, 0, 4, 7}, {4, 0, 8, 7}});
    const Surfaces surfaces = fitSurfaces(mesh, layout, dihedralAngles(mesh), {});
    EXPECT_TRUE(surfaces.folds.empty());
    EXPECT_EQ(missedTolerance(surfaces, {}), "");
    FitOptions paper;
    paper.fit = Fit::interpolate;
    EXPECT_FALSE(fitSurfaces(mesh, layout, dihedralAngles(mesh), paper).folds.empty())
        << "the paper's passes through every vertex";
}

} // namespace
} // namespace qm
