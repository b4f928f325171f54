#include "bspline/borders.h"
#include "bspline/bounding_box.h"
#include "bspline/deviation.h"
#include "bspline/interpolate.h"
#include "bspline/mesh_distance.h"
#include "support/grid_layout.h"

#include <gtest/gtest.h>

#include <cmath>

namespace qm {
namespace {

using test::Grid;

std::vector<Patch> interpolateAll(const QuadMesh& mesh, const Layout& layout) {
    std::vector<Patch> patches;
    for (const Segment& segment : layout.segments)
        patches.push_back(interpolate(pointGrid(mesh, segment), segment.size));
    return patches;
}

std::vector<double> allSmooth(const QuadMesh& mesh) {
    return std::vector<double>(mesh.n_edges(), 0.0);
}

MeasuredDeviation measure(const QuadMesh& mesh, const Layout& layout, const std::vector<Patch>& patches,
                          const Control& control = {}) {
    const std::vector<double> angles = allSmooth(mesh);
    return DeviationMeter(mesh, layout, angles, {}).measure(patches, control);
}

DeviatingPlaces find(const QuadMesh& mesh, const Layout& layout, const std::vector<Patch>& patches,
                     const DeviationLimits& limits) {
    const std::vector<double> angles = allSmooth(mesh);
    return DeviationMeter(mesh, layout, angles, {}).find(patches, limits);
}

const Grid plane{8, 6, [](double i, double j) { return Point(i, j, 0); }};
// Three rectangles that meet at a T-joint, each turned in another way.
const std::vector<test::Rectangle> tJoint = {{0, 0, 8, 3, 2}, {0, 3, 5, 6, 1}, {5, 3, 8, 6, 3}};

TEST(MeshDistance, IsZeroOnABilinearQuadAndExactAboveAFlatOne) {
    const QuadCorners twisted = {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 1), Point(0, 1, 0)};
    EXPECT_LT(distanceToQuad(twisted, bilinear(twisted, 0.3, 0.8)), 1e-12);
    const QuadCorners flat = {Point(0, 0, 0), Point(2, 0, 0), Point(2, 2, 0), Point(0, 2, 0)};
    EXPECT_NEAR(distanceToQuad(flat, {1.5, 0.5, 3}), 3, 1e-12);
    EXPECT_NEAR(distanceToQuad(flat, {3, -1, 0}), std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(distanceToQuad(flat, {1, -2, 0}), 2, 1e-12);
}

TEST(MeshDistance, FindsTheNearestQuadNotTheGivenOne) {
    // A sheet folded back over itself: the nearest point lies on a far part of the grid.
    const Grid fold{20, 2,
                    [](double i, double j) { return i <= 10 ? Point(i, j, 0) : Point(20 - i, j, 0.5); }};
    const MeshDistance distance(test::makeMesh(fold));
    EXPECT_NEAR(distance({3.5, 1, 0.4}, 10), 0.1, 1e-12);
    EXPECT_NEAR(distance({3.5, 1, 0.4}, 0.15), 0.1, 1e-12);
    EXPECT_NEAR(distance({3.5, 1, 0.1}, 0.4), 0.1, 1e-12);
}

TEST(Borders, NameBothSidesOfEveryEdge) {
    const QuadMesh mesh = test::makeMesh(plane);
    const Layout layout = test::makeLayout(plane, tJoint);
    const auto borders = borderEdges(mesh, layout);
    std::size_t inner = 0;
    for (const BorderEdge& border : borders) {
        EXPECT_EQ(border.places.size(), mesh.is_boundary(mesh.edge_handle(border.halfedge)) ? 1U : 2U);
        inner += border.places.size() == 2 ? 1 : 0;
        for (std::size_t p = 0; p < border.places.size(); ++p) {
            const BorderPlace& place = border.places[p];
            const auto& side = layout.segments[place.patch].sides[static_cast<std::size_t>(place.side)];
            const HalfedgeId halfedge =
                p == 0 ? border.halfedge : mesh.opposite_halfedge_handle(border.halfedge);
            EXPECT_EQ(side[static_cast<std::size_t>(place.position)], mesh.from_vertex_handle(halfedge));
            EXPECT_EQ(side[static_cast<std::size_t>(place.position) + 1], mesh.to_vertex_handle(halfedge));
        }
    }
    EXPECT_EQ(inner, 8U + 3U);
    EXPECT_EQ(borders.size(), 11U + 28U);
}

TEST(Deviation, OfAFlatSheetIsNothing) {
    const QuadMesh mesh = test::makeMesh(plane);
    const Layout layout = test::makeLayout(plane, tJoint);
    const auto measured = measure(mesh, layout, interpolateAll(mesh, layout));
    EXPECT_LT(measured.ofAll.max, 0.04) << "free ends slide along the boundary";
    EXPECT_LT(measured.ofAll.largestKink, 1e-9);
    EXPECT_LT(measured.ofAll.largestNormalDeviation, 1e-9);
    ASSERT_EQ(measured.ofPatch.size(), 3U);
}

TEST(Deviation, FindsADisplacementTwoSidedAndRelative) {
    const QuadMesh mesh = test::makeMesh(plane);
    const Layout layout = test::makeLayout(plane, tJoint);
    auto patches = interpolateAll(mesh, layout);
    for (Point& point : patches[1].controlPoints)
        point += Point(0, 0, 0.5);
    const auto measured = measure(mesh, layout, patches);
    EXPECT_NEAR(boundingBoxDiagonal(mesh), 10, 1e-12);
    EXPECT_NEAR(measured.ofPatch[1].rms, 0.5, 1e-3);
    EXPECT_NEAR(measured.ofPatch[1].percentile95, 0.5, 1e-3);
    EXPECT_NEAR(measured.ofAll.maxRelative, measured.ofAll.max / 10, 1e-15);
    EXPECT_NEAR(measured.ofAll.largestGap, 0.5, 5e-3);
    EXPECT_NEAR(measured.ofPatch[0].largestGap, measured.ofPatch[1].largestGap, 1e-12);
    EXPECT_LT(measured.ofPatch[0].max, 0.04);
    EXPECT_LT(measured.ofAll.rms, measured.ofPatch[1].rms);
}

TEST(Deviation, SeesOscillationBetweenVertices) {
    // A step in the middle of a patch: the interpolating surface overshoots beside it.
    const Grid step{12, 6, [](double i, double j) { return Point(i, j, i < 6 ? 0 : 3); }};
    const QuadMesh mesh = test::makeMesh(step);
    const Layout layout = test::makeLayout(step, {{0, 0, 12, 6}});
    const auto measured = measure(mesh, layout, interpolateAll(mesh, layout));
    EXPECT_GT(measured.ofAll.max, 0.15);
    EXPECT_GT(measured.ofAll.largestNormalDeviation, 5);
}

TEST(Deviation, TellsWherePatchesAreTooFarOrKinked) {
    const QuadMesh mesh = test::makeMesh(plane);
    const Layout layout = test::makeLayout(plane, tJoint);
    auto patches = interpolateAll(mesh, layout);
    for (Point& point : patches[1].controlPoints)
        point += Point(0, 0, 0.5);
    DeviationLimits limits;
    limits.farthest = 0.1;
    const auto places = find(mesh, layout, patches, limits);
    EXPECT_TRUE(places[0].empty());
    ASSERT_FALSE(places[1].empty());
    for (const DeviatingPlace& place : places[1])
        EXPECT_NEAR(place.distance, 0.5, 0.05);

    const Grid roof{8, 4, [](double i, double j) { return Point(i, j, -std::abs(i - 4)); }};
    const Grid flat{8, 4, [](double i, double j) { return Point(i, j, 0); }};
    const Layout halves = test::makeLayout(roof, {{0, 0, 4, 4}, {4, 0, 8, 4}});
    const QuadMesh bent = test::makeMesh(roof);
    const auto kinked = interpolateAll(bent, halves);
    limits = {};
    limits.mostKinked = 45;
    EXPECT_TRUE(find(bent, halves, kinked, limits)[0].empty()) << "the quads have that kink as well";
    const QuadMesh even = test::makeMesh(flat);
    const auto strange = find(even, halves, kinked, limits);
    ASSERT_FALSE(strange[0].empty());
    EXPECT_EQ(strange[0][0].at[0], 4);
    EXPECT_EQ(strange[1][0].at[0], 0);
    EXPECT_EQ(strange[1][0].distance, 0);
}

TEST(Deviation, FindsPlacesExactlyWhereItMeasuresTooMuch) {
    const Grid step{12, 6, [](double i, double j) { return Point(i, j, i < 6 ? 0 : 3); }};
    const QuadMesh mesh = test::makeMesh(step);
    const Layout layout = test::makeLayout(step, {{0, 0, 12, 3}, {0, 3, 12, 6, 1}});
    const auto patches = interpolateAll(mesh, layout);
    const Deviation most = measure(mesh, layout, patches).ofAll;
    for (const double share : {0.5, 0.999, 1.001}) {
        DeviationLimits far;
        far.farthest = share * most.max;
        EXPECT_EQ(find(mesh, layout, patches, far)[0].empty(), share > 1);
        DeviationLimits bent;
        bent.mostBent = share * most.largestNormalDeviation;
        EXPECT_EQ(find(mesh, layout, patches, bent)[0].empty(), share > 1);
    }
    const std::vector<double> angles = allSmooth(mesh);
    DeviationLimits far;
    far.farthest = 0.5 * most.max;
    const auto second = DeviationMeter(mesh, layout, angles, {}).find(patches, far, {false, true});
    EXPECT_TRUE(second[0].empty());
    EXPECT_FALSE(second[1].empty());
}

TEST(Deviation, MeasuresKinksOnSmoothBordersOnly) {
    const Grid roof{8, 4, [](double i, double j) { return Point(i, j, -std::abs(i - 4)); }};
    const QuadMesh mesh = test::makeMesh(roof);
    const Layout layout = test::makeLayout(roof, {{0, 0, 4, 4}, {4, 0, 8, 4}});
    const auto patches = interpolateAll(mesh, layout);
    const auto kinked = measure(mesh, layout, patches);
    EXPECT_NEAR(kinked.ofAll.largestKink, 90, 1e-6);
    EXPECT_NEAR(kinked.ofAll.rmsKink, 90, 1e-6);
    EXPECT_LT(kinked.ofAll.largestGap, 1e-12);
    const std::vector<double> sharp(mesh.n_edges(), 1.5);
    EXPECT_EQ(DeviationMeter(mesh, layout, sharp, {}).measure(patches).ofAll.largestKink, 0);
}

TEST(Deviation, DoesNotDependOnTheNumberOfThreads) {
    const Grid waves{40, 30, [](double i, double j) { return Point(i, j, std::sin(i) * std::cos(0.5 * j)); }};
    const QuadMesh mesh = test::makeMesh(waves);
    const Layout layout = test::makeLayout(waves, {{0, 0, 40, 7}, {0, 7, 11, 30}, {11, 7, 40, 30, 1}});
    const auto patches = interpolateAll(mesh, layout);
    Control control;
    const auto one = measure(mesh, layout, patches, control);
    control.jobs = 3;
    const auto three = measure(mesh, layout, patches, control);
    EXPECT_EQ(one.ofAll.rms, three.ofAll.rms);
    EXPECT_EQ(one.ofAll.max, three.ofAll.max);
    EXPECT_EQ(one.ofAll.rmsKink, three.ofAll.rmsKink);
    EXPECT_EQ(one.ofPatch[2].percentile95, three.ofPatch[2].percentile95);
}

} // namespace
} // namespace qm
