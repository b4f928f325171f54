/// \file Edges between analytic faces: where these meet, as simple curves, and one where they are one curve.
#include "support/exported_shape.h"

#include <gtest/gtest.h>

#include <BRep_Tool.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Lin.hxx>
#include <vector>

namespace qm {
namespace {

using test::all;
using test::analytic;
using test::countSurfaces;
using test::cup;
using test::fitted;
using test::FittedModel;
using test::Grid;
using test::joiningAnalytic;
using test::readBack;
using test::tube;

TEST(AnalyticEdges, AreWhereSurfacesMeet) {
    const FittedModel model = cup();
    const TopoDS_Shape shape = readBack(model, analytic());
    EXPECT_EQ(countSurfaces<Geom_Plane>(shape), 1);
    Handle(Geom_CylindricalSurface) cylinder;
    for (const TopoDS_Shape& face : all(shape, TopAbs_FACE))
        if (const auto found =
                Handle(Geom_CylindricalSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(face)));
            !found.IsNull())
            cylinder = found;
    ASSERT_FALSE(cylinder.IsNull());
    int rims = 0;
    for (const TopoDS_Shape& edge : all(shape, TopAbs_EDGE)) {
        double first = 0;
        double last = 0;
        const auto curve = BRep_Tool::Curve(TopoDS::Edge(edge), first, last);
        if (std::abs(curve->Value(first).Z() - 3) > 0.01 || std::abs(curve->Value(last).Z() - 3) > 0.01 ||
            gp_Lin(cylinder->Axis()).Distance(curve->Value((first + last) / 2)) < 1.9)
            continue;
        ++rims;
        for (int k = 0; k <= 100; ++k) {
            const gp_Pnt point = curve->Value(first + (last - first) * k / 100);
            EXPECT_NEAR(point.Z(), 3, 1e-7);
            EXPECT_NEAR(gp_Lin(cylinder->Axis()).Distance(point), cylinder->Radius(), 1e-7);
        }
    }
    EXPECT_EQ(rims, 1);
}

template <class Curve> int countCurves(const TopoDS_Shape& shape) {
    int count = 0;
    for (const TopoDS_Shape& edge : all(shape, TopAbs_EDGE)) {
        double first = 0;
        double last = 0;
        if (BRep_Tool::Curve(TopoDS::Edge(edge), first, last)->IsKind(STANDARD_TYPE(Curve))) ++count;
    }
    return count;
}

/// A sheet with a sharp bend, or bent around a cylinder and cut off at an angle: four patches.
FittedModel bent(bool isRound, double slope) {
    const Grid grid{
        36, 8, [=](double i, double j) {
            const double away = j <= 4 ? 1 + j / 2 : 3;
            const double angle = 0.07 * i;
            const double height = j <= 4 ? 0 : (j - 4) / 2;
            const Point point(isRound ? away * std::cos(angle) : i, isRound ? away * std::sin(angle) : away,
                              height);
            return point + Point(0, 0, slope * point[0] * std::max(0.0, 1 - (j > 4 ? 0.25 * (j - 4) : 0)));
        }};
    FitOptions options;
    options.tolerance.value = 0.01;
    return fitted(grid, {{0, 0, 15, 4}, {15, 0, 36, 4}, {0, 4, 20, 8}, {20, 4, 36, 8}}, options);
}

TEST(AnalyticEdges, AreLinesCirclesAndEllipses) {
    EXPECT_EQ(countCurves<Geom_Line>(readBack(bent(false, 0), analytic())), 3) << "of the bend";
    EXPECT_EQ(countCurves<Geom_Circle>(readBack(bent(true, 0), analytic())), 3);
    EXPECT_EQ(countCurves<Geom_Ellipse>(readBack(bent(true, 0.3), analytic())), 3);
    EXPECT_EQ(countCurves<Geom_Line>(readBack(bent(false, 0))), 0) << "only on request";
}

TEST(MergeEdges, MakesOneEdgeOfWhatIsOneCurve) {
    const TopoDS_Shape flat = readBack(bent(false, 0), joiningAnalytic());
    EXPECT_EQ(all(flat, TopAbs_FACE).size(), 2U);
    EXPECT_EQ(countCurves<Geom_Line>(flat), 1);
    for (const double slope : {0.0, 0.3}) {
        const TopoDS_Shape round = readBack(bent(true, slope), joiningAnalytic());
        EXPECT_EQ(countSurfaces<Geom_Plane>(round), 1);
        EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(round), 1);
        EXPECT_EQ(countCurves<Geom_Ellipse>(round), slope > 0 ? 1 : 0);
        EXPECT_EQ(countCurves<Geom_Circle>(round), slope > 0 ? 0 : 1);
    }
}

/// The largest distance of an edge from the surfaces of faces, at the same parameters, over its tolerance.
double excess(const TopoDS_Edge& edge, const std::vector<TopoDS_Shape>& faces) {
    double first = 0;
    double last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    double largest = 0;
    for (const TopoDS_Shape& shape : faces) {
        const TopoDS_Face face = TopoDS::Face(shape);
        const Handle(Geom2d_Curve) onFace = BRep_Tool::CurveOnSurface(edge, face, first, last);
        if (onFace.IsNull()) continue;
        constexpr int samples = 1000;
        for (int k = 0; k <= samples; ++k) {
            const double at = std::lerp(first, last, static_cast<double>(k) / samples);
            const gp_Pnt2d on = onFace->Value(at);
            largest =
                std::max(largest, curve->Value(at).Distance(BRep_Tool::Surface(face)->Value(on.X(), on.Y())));
        }
    }
    return largest / BRep_Tool::Tolerance(edge);
}

TEST(AnalyticEdges, AreNowhereFartherFromFacesThanTheySay) {
    const TopoDS_Shape shape = readBack(tube(0.5), analytic());
    const auto faces = all(shape, TopAbs_FACE);
    int loose = 0;
    for (const TopoDS_Shape& one : all(shape, TopAbs_EDGE)) {
        const TopoDS_Edge edge = TopoDS::Edge(one);
        if (BRep_Tool::Tolerance(edge) > 1e-6) ++loose;
        EXPECT_LE(excess(edge, faces), 1);
    }
    EXPECT_GT(loose, 0);
}

} // namespace
} // namespace qm
