#include "base/at.h"
#include "bspline/network/creases.h"
#include "features/features.h"
#include "mesh/dihedral.h"
#include "mesh/roundness.h"
#include "shape/shape.h"
#include "support/grid_layout.h"
#include "support/quad_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace qm {
namespace {

using test::Grid;

/// A sheet of 10 x 6 quads that is bent along i only: `angles` are the turns at i = 1, 2, ...
Grid bent(const std::vector<double>& angles) {
    std::vector<Point> profile{{0, 0, 0}};
    double direction = 0;
    for (int i = 0; i < 10; ++i) {
        profile.push_back(profile.back() + Point(std::cos(direction), 0, std::sin(direction)));
        if (i < static_cast<int>(angles.size())) direction += angles[static_cast<std::size_t>(i)];
    }
    return {10, 6, [=](double i, double j) { return profile[static_cast<std::size_t>(i)] + Point(0, j, 0); }};
}

/// The roundness of the line i = `column` of such a sheet.
double roundnessOf(const std::vector<double>& angles, int column) {
    const QuadMesh mesh = test::makeMesh(bent(angles));
    std::vector<HalfedgeId> line;
    for (int j = 0; j < 6; ++j)
        line.push_back(mesh.find_halfedge(VertexId(11 * j + column), VertexId(11 * (j + 1) + column)));
    return roundness(mesh, line);
}

TEST(Roundness, IsTheLesserBendBesideALineAsAShareOfItsOwn) {
    EXPECT_NEAR(roundnessOf({0, 0.3, 0.6, 0.5}, 3), 0.5, 1e-9);
    EXPECT_NEAR(roundnessOf({0, 0.5, 0.6, 0.3}, 3), 0.5, 1e-9) << "whichever side it is on";
    EXPECT_EQ(roundnessOf({0, 0.7, 0.6, 0.9}, 3), 1) << "at most";
    EXPECT_EQ(roundnessOf({0, 0, 0.6, 0.6}, 3), 0) << "plane on one side";
    EXPECT_EQ(roundnessOf({0, -0.6, 0.6, -0.6}, 3), 0) << "bent the other way";
    EXPECT_EQ(roundnessOf({}, 3), 0) << "plane";
}

TEST(Roundness, OfWhatIsTooSharpIsNone) {
    const double octagon = std::numbers::pi / 4;
    const double heptagon = 2 * std::numbers::pi / 7;
    EXPECT_NEAR(roundnessOf({octagon, octagon, octagon, octagon}, 2), 1, 1e-9);
    EXPECT_EQ(roundnessOf({heptagon, heptagon, heptagon, heptagon}, 2), 0);
}

TEST(Roundness, IsTheSameInBothDirectionsAndOnTheBoundaryOfTheMesh) {
    const QuadMesh mesh = makeShape("tube", {.around = 12});
    const std::vector<double> angles = dihedralAngles(mesh);
    for (const EdgeId edge : mesh.edges()) {
        if (mesh.is_boundary(edge)) continue;
        const HalfedgeId one = mesh.halfedge_handle(edge, 0);
        const HalfedgeId other = mesh.halfedge_handle(edge, 1);
        EXPECT_NEAR(roundness(mesh, {one}), roundness(mesh, {other}), 1e-12);
        EXPECT_NEAR(roundness(mesh, {one}), angles[at(edge)] > 0.1 ? 1 : 0, 1e-9);
    }
}

std::size_t creases(const QuadMesh& mesh) {
    const BorderMarks marks =
        markBorders(mesh, borderEdges(mesh, test::segmentPerQuad(mesh)), dihedralAngles(mesh), 0.45);
    return static_cast<std::size_t>(std::ranges::count_if(
        mesh.edges(), [&](EdgeId edge) { return marks.isCrease[at(edge)] && !mesh.is_boundary(edge); }));
}

TEST(Creases, CoarseRoundPartsHaveNone) {
    for (const char* part : {"sphere", "torus", "tube"})
        EXPECT_EQ(creases(makeShape(part, {.around = 12})), 0U) << part;
    EXPECT_EQ(creases(makeShape("cylinder", {.around = 12})), 24U) << "its two rims";
    EXPECT_EQ(creases(makeShape("cube", {.resolution = 1})), 12U);
}

TEST(Creases, ThatEndInNothingAreNoneWhereTheSurfaceIsSomewhatRound) {
    // A ridge along j = 3 that grows flat at both ends, with slopes beside it that bend by `beside`.
    const auto creasesOf = [](double beside) {
        const Grid grid{14, 6, [=](double i, double j) {
                            const bool isRidge = i > 2.5 && i < 11.5;
                            const double away = std::abs(j - 3);
                            return Point(i, j, isRidge ? -0.3 * away - beside * std::max(away - 1, 0.0) : 0);
                        }};
        const QuadMesh mesh = test::makeMesh(grid);
        const Layout layout = test::makeLayout(grid, {{0, 0, 14, 3}, {0, 3, 14, 6}});
        const auto isCrease =
            markBorders(mesh, borderEdges(mesh, layout), dihedralAngles(mesh), 0.45).isCrease;
        return std::ranges::count_if(
            mesh.edges(), [&](EdgeId edge) { return isCrease[at(edge)] && !mesh.is_boundary(edge); });
    };
    EXPECT_GT(creasesOf(0.05), 4);
    EXPECT_EQ(creasesOf(0.3), 0);
}

TEST(Features, AreNoLinesOfCoarseRoundParts) {
    const auto curves = [](const char* part, double maxRoundness) {
        const QuadMesh mesh = makeShape(part, {.around = 12});
        return findFeatures(mesh, dihedralAngles(mesh), {.tau = 2, .maxRoundness = maxRoundness})
            .curves.size();
    };
    EXPECT_EQ(curves("tube", 0.5), 0U);
    EXPECT_EQ(curves("tube", 1), 12U);
    EXPECT_EQ(curves("cylinder", 0.5), 2U) << "its rims";
}

} // namespace
} // namespace qm
