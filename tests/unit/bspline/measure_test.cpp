// Measurements of finished surfaces.
#include "bspline/measure/border_measures.h"
#include "bspline/measure/measure.h"
#include "bspline/measure/scan_deviation.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "bspline/splines/interpolate.h"
#include "mesh/bounding_box.h"
#include "support/grid_layout.h"

#include <gtest/gtest.h>

#include <cmath>

namespace qm {
namespace {

using test::Grid;

Measurement measure(const QuadMesh& mesh, const Layout& layout, const std::vector<Patch>& patches,
                    bool smooth = true, unsigned jobs = 1) {
    const std::vector<ReferenceGrid> facets = facetGrids(mesh, layout);
    return measureSurfaces({mesh, layout, patches, facets}, std::vector<bool>(mesh.n_edges(), smooth),
                           measureNegligible * boundingBox(mesh).diagonal(), jobs);
}

Grid plane() {
    return {8, 6, [](double i, double j) { return Point(i, j, 0); }};
}
/// Three rectangles that meet at a T-joint, each turned differently.
std::vector<test::Rectangle> tJoint() {
    return {{0, 0, 8, 3, 2}, {0, 3, 5, 6, 1}, {5, 3, 8, 6, 3}};
}

/// A bilinear patch over one quad.
Patch bilinearPatch(const std::array<Point, 4>& corners) {
    Patch patch;
    patch.degree = {1, 1};
    patch.knots = {{{0, 0, 1, 1}, {0, 0, 1, 1}}};
    patch.count = {2, 2};
    patch.controlPoints = {corners[0], corners[1], corners[3], corners[2]};
    return patch;
}

TEST(Measure, FindsADisplacementTwoSidedAndRelative) {
    const QuadMesh mesh = test::makeMesh(plane());
    const Layout layout = test::makeLayout(plane(), tJoint());
    auto patches = interpolateSegments(mesh, layout, 1);
    for (Point& point : patches[1].controlPoints)
        point += Point(0, 0, 0.5);
    const Measurement measured = measure(mesh, layout, patches);
    const Deviation& moved = measured.ofPatch[1].deviation;
    EXPECT_NEAR(moved.rms, 0.5, 1e-3);
    EXPECT_NEAR(moved.percentile95, 0.5, 1e-3);
    EXPECT_GE(moved.max, 0.5 - 1e-12);
    EXPECT_LE(moved.max, 0.51);
    EXPECT_EQ(moved.max, moved.maxFromFacets);
    EXPECT_NEAR(moved.maxFromVertices, 0.5, 1e-9);
    EXPECT_EQ(measured.ofAll.farthest.patch, 1U);
    const Deviation& all = measured.ofAll.deviation;
    EXPECT_NEAR(all.maxRelative, all.max / 10, 1e-15);
    EXPECT_NEAR(all.largestGap, 0.5, 5e-3);
    EXPECT_NEAR(measured.ofPatch[0].deviation.largestGap, moved.largestGap, 1e-12);
    EXPECT_LE(measured.ofPatch[0].deviation.max, moved.max / 2) << "free ends slide along the boundary";
    EXPECT_LT(all.rms, moved.rms);
    EXPECT_LT(all.largestNormalAngle, 1e-6);
    EXPECT_EQ(all.folds, 0U);
    EXPECT_NEAR(all.bendingRatio, 1, 1e-6) << "all is plane";
}

TEST(Measure, FindsVerticesManyPatchesAwayFromTheirPlacesInTheReference) {
    // The reference has the vertices of a plane elsewhere in the plane, as that of evened quads does.
    const int n = 32;
    const Grid even{n, n, [](double i, double j) { return Point(i, j, 0); }};
    const Grid uneven{n, n, [](double i, double j) { return Point(i * i / n, j * j / n, 0); }};
    std::vector<test::Rectangle> quads;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            quads.push_back({i, j, i + 1, j + 1});
    const Layout layout = test::makeLayout(even, quads);
    const QuadMesh reference = test::makeMesh(even), mesh = test::makeMesh(uneven);
    const auto grids = facetGrids(reference, layout);
    const auto patches = interpolateSegments(reference, layout, 1);
    const Measurement measured =
        measureSurfaces({mesh, layout, patches, grids}, std::vector<bool>(mesh.n_edges(), true), 1e-6, 2);
    EXPECT_LT(measured.ofAll.deviation.maxFromVertices, 1e-5);
}

TEST(Measure, SeesWhatHappensBetweenSamplesAtHalfEdges) {
    // A patch with a knot at every eighth of an edge and one displaced control point.
    const QuadMesh mesh = test::makeMesh({1, 1, [](double i, double j) { return Point(i, j, 0); }});
    const Layout layout = test::makeLayout({1, 1, plane().place}, {{0, 0, 1, 1}});
    Patch patch;
    for (auto& knots : patch.knots) {
        knots = {0, 0, 0, 0};
        for (int k = 1; k < 8; ++k)
            knots.push_back(k / 8.0);
        knots.insert(knots.end(), 4, 1);
    }
    patch.count = {11, 11};
    for (std::size_t j = 0; j < 11; ++j)
        for (std::size_t i = 0; i < 11; ++i) {
            const auto mean = [&](std::size_t k) {
                return (patch.knots[0][k + 1] + patch.knots[0][k + 2] + patch.knots[0][k + 3]) / 3;
            };
            patch.controlPoints.emplace_back(mean(i), mean(j), i == 4 && j == 4 ? 0.1 : 0);
        }
    const Measurement measured = measure(mesh, layout, {patch});
    EXPECT_NEAR(measured.ofAll.deviation.max, 0.1 * 4 / 9, 0.002);
    EXPECT_NEAR(measured.ofAll.farthest.at[0], 0.375, 0.02);
    EXPECT_GT(measured.ofAll.deviation.bendingRatio, 1000);
}

TEST(Measure, ComparesNormalsAcrossSmoothBordersOnly) {
    const Grid roof{8, 4, [](double i, double j) { return Point(i, j, -std::abs(i - 4)); }};
    const QuadMesh mesh = test::makeMesh(roof);
    const Layout layout = test::makeLayout(roof, {{0, 0, 4, 4}, {4, 0, 8, 4}});
    const auto patches = interpolateSegments(mesh, layout, 1);
    const Deviation bent = measure(mesh, layout, patches).ofAll.deviation;
    EXPECT_NEAR(bent.largestNormalAngle, 90, 1e-6);
    EXPECT_NEAR(bent.rmsNormalAngle, 90, 1e-6);
    EXPECT_NEAR(bent.percentile95NormalAngle, 90, 1e-6);
    EXPECT_LT(bent.largestGap, 1e-12);
    EXPECT_EQ(measure(mesh, layout, patches, false).ofAll.deviation.largestNormalAngle, 0);
}

TEST(Measure, FindsAnglesWithinPatches) {
    // A patch that is linear between knots: a roof.
    const Grid roof{2, 1, [](double i, double j) { return Point(i, j, -std::abs(i - 1)); }};
    const QuadMesh mesh = test::makeMesh(roof);
    const Layout layout = test::makeLayout(roof, {{0, 0, 2, 1}});
    Patch patch;
    patch.degree = {1, 1};
    patch.knots = {{{0, 0, 1, 2, 2}, {0, 0, 1, 1}}};
    patch.count = {3, 2};
    for (const double j : {0.0, 1.0})
        for (const double i : {0.0, 1.0, 2.0})
            patch.controlPoints.push_back(roof.place(i, j));
    EXPECT_NEAR(measure(mesh, layout, {patch}).ofAll.deviation.largestInnerNormalAngle, 90, 1e-6);
    EXPECT_LT(measure(mesh, layout, {patch}).ofAll.deviation.max, 1e-12);
    const MeetingMeasures smooth = measureInnerLines(interpolateSegments(mesh, layout, 1)[0], 16);
    EXPECT_TRUE(smooth.angles.empty()) << "simple knots of a cubic";
}

TEST(Measure, CountsFolds) {
    const QuadMesh mesh = test::makeMesh(plane());
    const Layout layout = test::makeLayout(plane(), {{0, 0, 8, 6}});
    auto patches = interpolateSegments(mesh, layout, 1);
    EXPECT_EQ(measure(mesh, layout, patches).ofAll.deviation.folds, 0U);
    patches[0].controlPoints[5 * 11 + 5] += Point(4, 0, 0);
    const Measurement folded = measure(mesh, layout, patches);
    EXPECT_GT(folded.ofAll.deviation.folds, 0U);
    EXPECT_EQ(folded.ofAll.deviation.folds, folded.ofPatch[0].folds.size());
    EXPECT_GT(folded.ofAll.deviation.largestNormalDeviation, 170);
}

/// Two triangles above a square.
TriangleSurface sheetAt(double height, double until) {
    const Point a(-1, -1, height), b(until, -1, height), c(until, 9, height), d(-1, 9, height);
    return TriangleSurface({{a, b, c, d}, {{0, 1, 2}, {0, 2, 3}}});
}

TEST(Measure, MeasuresFromAScan) {
    const QuadMesh mesh = test::makeMesh(plane());
    const Layout layout = test::makeLayout(plane(), tJoint());
    const auto patches = interpolateSegments(mesh, layout, 1);
    const auto from = [&](const TriangleSurface& scan, double cutOff = HUGE_VAL) {
        return deviationFromScan(patches, scan, cutOff, {}, 1);
    };
    const ScanDeviations whole = from(sheetAt(0.25, 9));
    EXPECT_NEAR(whole.max, 0.25, 0.0051);
    EXPECT_GE(whole.max, 0.25 - 1e-12);
    EXPECT_NEAR(whole.rms, 0.25, 1e-9);
    const ScanDeviations half = from(sheetAt(0.25, 4));
    EXPECT_NEAR(half.max, 0.25, 0.0051);
    EXPECT_EQ(from(sheetAt(0.25, 9), 0.2).max, 0) << "beyond the cut-off";
}

/// Triangles of a hundredth of a quad in a plane, around a few quads.
TriangleSurface manyTriangles() {
    constexpr int columns = 220;
    constexpr double size = 0.01;
    Triangles triangles;
    for (int j = 0; j <= columns; ++j)
        for (int i = 0; i <= columns; ++i) {
            triangles.points.emplace_back((i - 10) * size, (j - 10) * size, 0);
            if (i == columns || j == columns) continue;
            const int a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1;
            triangles.faces.push_back({a, b, c});
            triangles.faces.push_back({b, c + 1, c});
        }
    return TriangleSurface(triangles);
}

TEST(Measure, ManySmallTrianglesAreNotFartherAwayThanTheyAre) {
    const Grid few{2, 2, [](double i, double j) { return Point(i, j, 0.001); }};
    const auto patches =
        interpolateSegments(test::makeMesh(few), test::makeLayout(few, {{0, 0, 1, 2}, {1, 0, 2, 2, 1}}), 1);
    EXPECT_NEAR(deviationFromScan(patches, manyTriangles(), HUGE_VAL, {}, 1).max, 0.001, 1e-9);
}

TEST(Measure, DoesNotDependOnTheNumberOfThreads) {
    const Grid waves{40, 30, [](double i, double j) { return Point(i, j, std::sin(i) * std::cos(0.5 * j)); }};
    const QuadMesh mesh = test::makeMesh(waves);
    const Layout layout = test::makeLayout(waves, {{0, 0, 40, 7}, {0, 7, 11, 30}, {11, 7, 40, 30, 1}});
    const auto patches = interpolateSegments(mesh, layout, 1);
    const Deviation one = measure(mesh, layout, patches).ofAll.deviation;
    const Deviation three = measure(mesh, layout, patches, true, 3).ofAll.deviation;
    EXPECT_EQ(one.max, three.max);
    EXPECT_EQ(one.rms, three.rms);
    EXPECT_EQ(one.percentile95, three.percentile95);
    EXPECT_EQ(one.rmsNormalAngle, three.rmsNormalAngle);
    EXPECT_EQ(one.bendingRatio, three.bendingRatio);
}

TEST(Measure, StandsDegeneratePatches) {
    const Grid point{2, 2, [](double, double) { return Point(1, 2, 3); }};
    const QuadMesh mesh = test::makeMesh(point);
    const Layout layout = test::makeLayout(point, {{0, 0, 2, 2}});
    const Measurement measured = measure(mesh, layout, interpolateSegments(mesh, layout, 1));
    EXPECT_LT(measured.ofAll.deviation.max, 1e-12);
    EXPECT_EQ(measured.ofAll.deviation.folds, 4U) << "every piece is without a normal";
    const Grid quad{1, 1, [](double i, double j) { return Point(i, j, 0); }};
    const Patch folded = bilinearPatch({Point(0, 0, 0), Point(1, 0, 0), Point(0.2, 0.2, 0), Point(0, 1, 0)});
    EXPECT_EQ(
        measure(test::makeMesh(quad), test::makeLayout(quad, {{0, 0, 1, 1}}), {folded}).ofAll.deviation.folds,
        1U);
}

} // namespace
} // namespace qm
