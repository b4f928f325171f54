#include "bspline/splines/evaluate.h"
#include "export/boundary/boundary.h"
#include "export/faces/face_patches.h"
#include "export/files/shape.h"
#include "export/geometry/geometry.h"
#include "support/fitted_model.h"
#include "support/steps.h"

#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <algorithm>
#include <array>
#include <cmath>

namespace qm {
namespace {

using test::Bend;
using test::bentSheet;
using test::fitted;
using test::FittedModel;
using test::Grid;
using test::sheet;

double distance(const Patch& one, const Patch& other) {
    double largest = 0;
    for (const double u : test::steps(0, one.knots[0].back(), 0.37))
        for (const double v : test::steps(0, one.knots[1].back(), 0.37))
            largest =
                std::max(largest, (evaluate(one, u, v).position - evaluate(other, u, v).position).norm());
    return largest;
}

TEST(Separate, CutsWhereASurfaceIsOnlyContinuous) {
    const FittedModel model = bentSheet(Bend::sharp);
    const FacePatches faces = separated(model.mesh, facePatches(model.layout, model.surfaces.patches), 1e-9);
    ASSERT_EQ(faces.patches.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
        const Segment& segment = faces.layout.segments[k];
        EXPECT_EQ(segment.size, (std::array{2, 2}));
        EXPECT_EQ(segment.corners[0], VertexId(k == 0 ? 0 : 2));
        EXPECT_EQ(segment.corners[2], VertexId(k == 0 ? 12 : 14));
        EXPECT_EQ(segment.faces.front(), FaceId(k == 0 ? 0 : 2));
        const Point whole =
            evaluate(model.surfaces.patches[0], 0.7 + 2.0 * static_cast<double>(k), 1.2).position;
        EXPECT_LT((evaluate(faces.patches[k], 0.7, 1.2).position - whole).norm(), 1e-13);
    }
}

TEST(Separate, LeavesNoSideWithHundredsOfEdges) {
    const Grid grid{300, 2, [](double i, double j) { return Point(i, j, std::sin(0.1 * i)); }};
    std::vector<test::Rectangle> rectangles{{0, 0, 300, 1}};
    for (int k = 0; k < 300; ++k)
        rectangles.push_back({k, 1, k + 1, 2, 0});
    const FittedModel model = fitted(grid, rectangles, {});
    const FacePatches faces = separated(model.mesh, facePatches(model.layout, model.surfaces.patches), 1e-9);
    EXPECT_EQ(faces.patches.size(), 303U);
    for (const BoundaryFace& face : makeBoundary(model.mesh, faces).faces)
        EXPECT_LE(face.loops.front().size(), 131U);
}

TEST(KnotRemoval, KeepsTheSurface) {
    const Patch patch = bentSheet(Bend::none).surfaces.patches[0];
    const Patch lighter = withoutNeedlessKnots(patch, 1e-9);
    EXPECT_LT(lighter.count[0], patch.count[0]);
    EXPECT_LT(distance(lighter, patch), 1e-9);
    const Patch sharp = bentSheet(Bend::sharp).surfaces.patches[0];
    EXPECT_EQ(withoutNeedlessKnots(sharp, 1e-9).knots, sharp.knots);
}

TEST(QuarterTurn, TheSurfaceStaysWhereItIs) {
    const FittedModel model = fitted(sheet(), test::tJoint(), test::interpolating());
    const FacePatches faces = facePatches(model.layout, model.surfaces.patches);
    for (std::size_t f = 0; f < faces.patches.size(); ++f) {
        const Patch turned = quarterTurned(faces.patches[f]);
        const Segment segment = quarterTurned(faces.layout.segments[f]);
        const auto [a, b] = faces.layout.segments[f].size;
        EXPECT_EQ(segment.size, (std::array{b, a}));
        EXPECT_EQ(segment.corners[0], faces.layout.segments[f].corners[1]);
        for (const double u : {0.0, 0.3, 1.0})
            for (const double v : {0.0, 0.6, 1.0})
                EXPECT_LT((evaluate(turned, v * b, (1 - u) * a).position -
                           evaluate(faces.patches[f], u * a, v * b).position)
                              .norm(),
                          1e-12);
    }
}

TEST(Join, PutsTogetherWhatWasCut) {
    const FittedModel model = fitted(sheet(), {{0, 0, 10, 8}}, test::interpolating());
    const FacePatches whole = facePatches(model.layout, model.surfaces.patches);
    FacePatches parts;
    for (const std::array<int, 2> from :
         {std::array{0, 0}, std::array{4, 0}, std::array{0, 3}, std::array{4, 3}}) {
        const std::array<int, 2> to{from[0] == 0 ? 4 : 10, from[1] == 0 ? 3 : 8};
        parts.layout.segments.push_back(
            partOf(vertexGrid(model.mesh, whole.layout.segments[0]), whole.layout.segments[0], from, to));
        parts.patches.push_back(partOf(whole.patches[0], from, to));
        parts.origins.push_back({parts.origins.size()});
    }
    const FacePatches again = joined(parts, 1e-9);
    ASSERT_EQ(again.patches.size(), 1U);
    EXPECT_EQ(again.origins[0], (std::vector<std::size_t>{0, 1, 2, 3}));
    EXPECT_EQ(again.layout.segments[0].faces.size(), model.mesh.n_faces());
    EXPECT_EQ(again.patches[0].controlPoints.size(), whole.patches[0].controlPoints.size());
    const Segment& segment = again.layout.segments[0];
    for (std::size_t side = 0; side < 4; ++side)
        EXPECT_EQ(segment.sides[side].back(), segment.sides[(side + 1) % 4].front());
    GProp_GProps before;
    GProp_GProps after;
    BRepGProp::SurfaceProperties(buildShape(makeBoundary(model.mesh, whole)).shape, before);
    const BoundaryShape made = buildShape(makeBoundary(model.mesh, again));
    BRepGProp::SurfaceProperties(made.shape, after);
    EXPECT_TRUE(BRepCheck_Analyzer(made.shape).IsValid());
    EXPECT_NEAR(before.Mass(), after.Mass(), 1e-9 * before.Mass());
}

TEST(Join, LeavesWhatIsBentAndWhatWouldTouchItself) {
    const FittedModel bent = bentSheet(Bend::sharp);
    const FacePatches parts = separated(bent.mesh, facePatches(bent.layout, bent.surfaces.patches), 1e-9);
    EXPECT_EQ(joined(parts, 1e-9).patches.size(), 2U);
    const FittedModel ring = test::torus({{0, 0, 16, 12}});
    const FacePatches faces = separated(ring.mesh, facePatches(ring.layout, ring.surfaces.patches), 1e-9);
    for (const Segment& segment : joined(faces, 1e-9).layout.segments)
        EXPECT_FALSE(touchesItself(segment));
}

} // namespace
} // namespace qm
