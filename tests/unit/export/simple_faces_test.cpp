// Faces that need no control points, and faces that hang together.
#include "base/at.h"
#include "bspline/splines/clamped_patch.h"
#include "bspline/splines/spline_curve.h"
#include "export/boundary/boundary_parts.h"
#include "export/boundary/simple_faces.h"
#include "export/faces/face_patches.h"
#include "export/geometry/geometry.h"
#include "export/simple/curve_on_surface.h"
#include "support/fitted_model.h"

#include <gtest/gtest.h>

#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <cmath>
#include <vector>

namespace qm {
namespace {

using test::cup;
using test::FittedModel;

/// The faces of a model and the edges that they share.
struct SharedFaces {
    explicit SharedFaces(const FittedModel& model)
        : faces(facePatches(model.layout, model.surfaces.patches)),
          shared(shareEdges(model.mesh, faces.layout, faces.patches)) {}
    FacePatches faces;
    SharedEdges shared;
};

TEST(SimpleFaces, MeetInExactCurves) {
    const FittedModel model = cup();
    SharedFaces made(model);
    const SimpleFaces simple(made.faces, made.shared, {1e-6, 1e-7, {0.01, 0.01}});
    SimpleFaces moved = simple;
    moved.moveVertices(made.shared);
    for (std::size_t face = 0; face < 2; ++face)
        ASSERT_TRUE(simple[face]) << face;
    std::size_t exact = 0;
    for (const SharedEdge& edge : made.shared.edges) {
        const BorderPlace& place = edge.places.front();
        const auto border = splineCurve(restricted(borderCurve(made.faces.patches[place.patch], place.side),
                                                   place.position, place.position + edge.length));
        EXPECT_FALSE(simple.exactCurve(edge, made.shared, border)) << "no vertex has been moved";
        const auto curve = moved.exactCurve(edge, made.shared, border);
        EXPECT_EQ(curve.has_value(), edge.places.size() > 1);
        if (!curve) continue;
        ++exact;
        for (const std::size_t face : {edge.places[0].patch, edge.places[1].patch})
            EXPECT_LT(curveOnSurface(*curve, *simple[face], 1e-7).gap, 1e-7);
    }
    EXPECT_EQ(exact, 1U);
}

TEST(SimpleFaces, AreNothingButPlanesUnlessMoreIsAllowed) {
    const FittedModel model = cup();
    SharedFaces made(model);
    SimpleFaces simple(made.faces, made.shared, {1e-3, 1e-7, {}});
    EXPECT_FALSE(simple[0]) << "a cylinder";
    EXPECT_TRUE(simple[1]);
    const std::vector<Point> before = made.shared.vertexPoint;
    simple.moveVertices(made.shared);
    EXPECT_EQ(made.shared.vertexPoint, before);
}

TEST(SimpleFaces, BordersEndWhereVerticesHaveBeenMoved) {
    const FittedModel model = cup();
    SharedFaces made(model);
    SimpleFaces simple(made.faces, made.shared, {1e-6, 1e-7, {0.01, 0.01}});
    simple.moveVertices(made.shared);
    const SharedEdge& edge = made.shared.edges.front();
    const auto border =
        splineCurve(borderCurve(made.faces.patches[edge.places.front().patch], edge.places.front().side));
    const Point away(0, 0, 0.5);
    made.shared.vertexPoint[at(edge.start)] = fromGp(border->StartPoint());
    made.shared.vertexPoint[at(edge.end)] = fromGp(border->EndPoint()) + away;
    const auto moved = simple.movedBorder(edge, made.shared, border);
    for (const double share : {0.0, 0.3, 1.0}) {
        const double parameter = std::lerp(border->FirstParameter(), border->LastParameter(), share);
        EXPECT_LT((fromGp(moved->Value(parameter)) - fromGp(border->Value(parameter)) - share * away).norm(),
                  1e-12);
    }
    const SimpleFaces planesOnly(made.faces, made.shared, {1e-6, 1e-7, {}});
    EXPECT_EQ(planesOnly.movedBorder(edge, made.shared, border), border);
}

TEST(CommonCurve, IsNoFinerThanHelpsWhereSurfacesDoNotMeet) {
    const auto parabola = [] {
        TColgp_Array1OfPnt poles(1, 3);
        poles(1) = {0, 0, 0};
        poles(2) = {1, 1, 0};
        poles(3) = {2, 0, 0};
        TColStd_Array1OfReal knots(1, 2);
        knots(1) = 0;
        knots(2) = 1;
        TColStd_Array1OfInteger times(1, 2);
        times.Init(3);
        return Handle(Geom_BSplineCurve)(new Geom_BSplineCurve(poles, knots, times, 2));
    }();
    const gp_Pnt end(2, 0, 0);
    const auto plane = [](double height, double slope) {
        return SimpleSurface{new Geom_Plane(gp_Pnt(0, 0, height), gp_Dir(0, -slope, 1)), false, 0};
    };
    const auto knots = [&](const std::vector<SimpleSurface>& both) {
        return commonCurve(parabola, {gp_Pnt(0, 0, 0), end}, both, 1e-9)->NbKnots();
    };
    EXPECT_LE(knots({plane(0, 0), plane(0.001, 0)}), 5);
    EXPECT_LE(knots({plane(0, 0), plane(0, 0)}), 5);
    const SimpleSurface cylinder{
        new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(1, 0, 1), gp_Dir(0, 1, 0)), std::sqrt(2.0)), false, 0};
    EXPECT_GT(knots({cylinder, cylinder}), 5) << "which no cubic follows exactly";
}

TEST(BoundaryParts, AreClosedAndLookInwardsOrNot) {
    const FittedModel open = cup();
    const SharedFaces cupFaces(open);
    const auto sheet = boundaryParts(open.mesh, cupFaces.faces.layout, cupFaces.shared);
    ASSERT_EQ(sheet.size(), 1U);
    EXPECT_EQ(sheet[0].faces, (std::vector<std::size_t>{0, 1}));
    EXPECT_FALSE(sheet[0].closed || sheet[0].inward);

    FittedModel closed = test::torus({{0, 0, 8, 12}, {8, 0, 16, 12}});
    const SharedFaces ring(closed);
    const auto parts = [&] { return boundaryParts(closed.mesh, ring.faces.layout, ring.shared); };
    ASSERT_EQ(parts().size(), 1U);
    EXPECT_TRUE(parts()[0].closed);
    const bool inward = parts()[0].inward;
    for (const VertexId vertex : closed.mesh.vertices()) {
        const Point point = closed.mesh.point(vertex);
        closed.mesh.set_point(vertex, {point[0], point[1], -point[2]});
    }
    EXPECT_NE(parts()[0].inward, inward) << "its mirror image";
}

} // namespace
} // namespace qm
