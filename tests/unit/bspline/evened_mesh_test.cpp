#include "bspline/fit.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/improvement/evened_mesh.h"
#include "mesh/dihedral.h"
#include "mesh/quad_geometry.h"
#include "shape/shape.h"
#include "support/cheapest_layout.h"
#include "support/grid_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace qm {
namespace {

using test::Grid;

constexpr int columns = 12;
constexpr int rows = 16;
constexpr double flatness = 1e-5;

VertexId vertexAt(int i, int j) {
    return VertexId(j * (columns + 1) + i);
}

/// Lines along u turn by 90 degrees in the middle.
double turning(double i, double j) {
    return j + std::abs(i - 6);
}

Point inPlane(double i, double j) {
    return {i, turning(i, j), 2};
}

/// Both sides of a roof, whose ridge is line 8.
Point onRoof(double i, double j) {
    const double y = (j - 8) * (1 + 0.1 * std::abs(i - 6));
    return {i, y, -std::abs(y)};
}

Point onCylinder(double i, double j) {
    return {i, 20 * std::sin(turning(i, j) / 20), 20 * std::cos(turning(i, j) / 20)};
}

std::optional<QuadMesh> evened(const Grid& grid, const std::vector<test::Rectangle>& rectangles) {
    const QuadMesh mesh = test::makeMesh(grid);
    const Layout layout = test::makeLayout(grid, rectangles);
    const SmoothNetwork network = buildNetwork(mesh, layout, dihedralAngles(mesh), defaultRho);
    return evenedMesh(mesh, network.marks.isCrease, flatness, 2);
}

/// The largest turn of a line along u at a vertex within the mesh.
double sharpestTurn(const QuadMesh& mesh) {
    double sharpest = 0;
    for (int j = 3; j < rows - 2; ++j)
        for (int i = 3; i < columns - 2; ++i) {
            const Point before = mesh.point(vertexAt(i, j)) - mesh.point(vertexAt(i - 1, j));
            const Point after = mesh.point(vertexAt(i + 1, j)) - mesh.point(vertexAt(i, j));
            sharpest = std::max(sharpest, std::acos((before | after) / before.norm() / after.norm()));
        }
    return sharpest;
}

bool isWithinTwoRings(int i, int j) {
    return std::min({i, j, columns - i, rows - j}) < 2;
}

TEST(EvenedMesh, LinesTurnLessWithinThePlaneAndTheOutermostRingsStay) {
    const Grid grid{columns, rows, inPlane};
    const QuadMesh before = test::makeMesh(grid);
    const auto after = evened(grid, {{0, 0, columns, 9}, {0, 9, columns, rows}});
    ASSERT_TRUE(after);
    EXPECT_GT(sharpestTurn(before), 1.5);
    EXPECT_LT(sharpestTurn(*after), 0.8);
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const Point moved = after->point(vertexAt(i, j)) - before.point(vertexAt(i, j));
            EXPECT_NEAR(moved[2], 0, 1e-12);
            if (isWithinTwoRings(i, j)) {
                EXPECT_EQ(moved.norm(), 0) << i << ", " << j;
            }
        }
    EXPECT_TRUE(std::ranges::none_of(after->faces(), [&](FaceId face) { return isFolded(*after, face); }));
}

TEST(EvenedMesh, LeavesEvenQuadsAndCurvedSurfaces) {
    const auto onGrid = [](double i, double j) { return Point(i, 1.5 * j, 0); };
    EXPECT_FALSE(evened({columns, rows, onGrid}, {{0, 0, columns, rows}}));
    EXPECT_FALSE(evened({columns, rows, onCylinder}, {{0, 0, columns, rows}}));
}

TEST(EvenedMesh, LeavesCreasesAndWhatLiesBesideThem) {
    const Grid grid{columns, rows, onRoof};
    const QuadMesh before = test::makeMesh(grid);
    const auto after = evened(grid, {{0, 0, columns, 8}, {0, 8, columns, rows}});
    ASSERT_TRUE(after);
    EXPECT_LT(sharpestTurn(*after), sharpestTurn(before));
    for (int i = 0; i <= columns; ++i)
        for (int j = 7; j <= 9; ++j)
            EXPECT_EQ(after->point(vertexAt(i, j)), before.point(vertexAt(i, j)));
    for (int j = 0; j <= rows; ++j)
        EXPECT_NEAR(after->point(vertexAt(6, j))[2], -std::abs(after->point(vertexAt(6, j))[1]), 1e-12);
}

TEST(EvenedMesh, LeavesWhatWouldTurnOver) {
    // A first row as wide: what continues it smoothly leads beyond the last one.
    const auto wideFirst = [](double i, double j) { return Point(i, j < 1 ? 5 * j : 5 + 0.1 * (j - 1), 0); };
    EXPECT_FALSE(evened({columns, rows, wideFirst}, {{0, 0, columns, rows}}));
}

TEST(EvenedMesh, SurfacesOfPlatesAroundHolesKeepTheToleranceWithoutFolds) {
    // Between the squares around its hole and the circle the plate's lines turn by up to 90 degrees.
    for (const int resolution : {16, 32}) {
        const QuadMesh mesh = makeShape("plate", {.resolution = resolution});
        const Layout layout = test::cheapestLayout(mesh);
        const Surfaces surfaces = fitSurfaces(mesh, layout, dihedralAngles(mesh), {});
        EXPECT_EQ(missedTolerance(surfaces, {}), "") << resolution;
        EXPECT_TRUE(surfaces.folds.empty()) << resolution;
        // Measured from where vertices and quads were before.
        EXPECT_LE(surfaces.deviation.maxFromVertices, 1.02 * surfaces.deviation.max) << resolution;
        EXPECT_LE(surfaces.deviation.maxFromFacets, 1.02 * surfaces.deviation.max + 1e-3) << resolution;
    }
}

} // namespace
} // namespace qm
