#include "export/boundary/shared_edges.h"
#include "export/export.h"
#include "support/fitted_model.h"

#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <gp_Lin.hxx>
#include <numbers>
#include <sstream>

namespace qm {
namespace {

using test::cup;
using test::fitted;
using test::FittedModel;
using test::Grid;
using test::sheet;

TopoDS_Shape readBack(const FittedModel& model, const ExportOptions& options = {}) {
    STEPControl_Reader reader;
    std::istringstream stream(exportModel(model.mesh, model.layout, &model.surfaces, options).bytes);
    EXPECT_EQ(reader.ReadStream("shape.step", stream), IFSelect_RetDone);
    EXPECT_GT(reader.TransferRoots(), 0);
    EXPECT_TRUE(BRepCheck_Analyzer(reader.OneShape()).IsValid());
    return reader.OneShape();
}

/// All sub-shapes of a kind, each once.
std::vector<TopoDS_Shape> all(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape found;
    TopExp::MapShapes(shape, kind, found);
    std::vector<TopoDS_Shape> result;
    for (int k = 1; k <= found.Extent(); ++k)
        result.push_back(found(k));
    return result;
}

template <class Surface> int countSurfaces(const TopoDS_Shape& shape) {
    int count = 0;
    for (const TopoDS_Shape& face : all(shape, TopAbs_FACE))
        if (!Handle(Surface)::DownCast(BRep_Tool::Surface(TopoDS::Face(face))).IsNull()) ++count;
    return count;
}

int countSmoothEdges(const TopoDS_Shape& shape) {
    int count = 0;
    for (const TopoDS_Shape& edge : all(shape, TopAbs_EDGE))
        if (BRep_Tool::MaxContinuity(TopoDS::Edge(edge)) >= GeomAbs_G1) ++count;
    return count;
}

double volume(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

TEST(Separate, ReadersFindOnlySmoothSurfaces) {
    const TopoDS_Shape shape = readBack(test::bentSheet(test::Bend::sharp));
    EXPECT_EQ(all(shape, TopAbs_FACE).size(), 2U);
    EXPECT_EQ(countSmoothEdges(shape), 0);
    for (const TopoDS_Shape& face : all(shape, TopAbs_FACE))
        EXPECT_GE(BRep_Tool::Surface(TopoDS::Face(face))->Continuity(), GeomAbs_C1);
}

TEST(Separate, LeavesASmoothSurfaceWhole) {
    const FittedModel model = test::bentSheet(test::Bend::none);
    const TopoDS_Shape shape = readBack(model);
    ASSERT_EQ(all(shape, TopAbs_FACE).size(), 1U) << "its triple knot is not needed";
    const auto surface = Handle(Geom_BSplineSurface)::DownCast(
        BRep_Tool::Surface(TopoDS::Face(all(shape, TopAbs_FACE).front())));
    ASSERT_FALSE(surface.IsNull());
    for (int k = 2; k < surface->NbUKnots(); ++k)
        EXPECT_EQ(surface->UMultiplicity(k), 1);
}

TEST(Edges, AreFoundSmoothByTheReader) {
    // A roof with a sharp ridge, and a seam without any bend.
    const Grid grid{8, 4, [](double i, double j) { return Point(i, j, 0.1 * i * i - std::abs(j - 2)); }};
    const FittedModel model = fitted(grid, {{0, 0, 8, 2}, {0, 2, 3, 4}, {3, 2, 8, 4}}, FitOptions());
    const ShapeReport report = *exportModel(model.mesh, model.layout, &model.surfaces, {}).shape;
    const TopoDS_Shape shape = readBack(model);
    EXPECT_GT(report.smoothEdges, 0U);
    EXPECT_EQ(countSmoothEdges(shape), static_cast<int>(report.smoothEdges));
    for (const TopoDS_Shape& edge : all(shape, TopAbs_EDGE))
        EXPECT_LE(BRep_Tool::Tolerance(TopoDS::Edge(edge)), 1.0001e-7);
}

TEST(Edges, AreSmoothOrSharpNeverBoth) {
    // A roof whose ridge begins halfway along the border of its two faces.
    const Grid grid{8, 4, [](double i, double j) { return Point(i, j, i < 4 ? 0.0 : -2 * std::abs(j - 2)); }};
    const FittedModel model = fitted(grid, {{0, 0, 8, 2}, {0, 2, 8, 4}}, FitOptions());
    const SharedEdges shared = shareEdges(model.mesh, model.layout, model.surfaces.patches);
    std::vector<int> smooth;
    std::vector<int> sharp;
    for (const SharedEdge& edge : shared.edges)
        if (edge.places.size() == 2) (edge.angle < 0.01 ? smooth : sharp).push_back(edge.length);
    EXPECT_EQ(smooth, std::vector{3}) << "the first quads that bend are those before vertex 4";
    EXPECT_EQ(sharp, std::vector{5});
    EXPECT_EQ(countSmoothEdges(readBack(model)), 1);
}

TEST(Planes, AreExportedAsPlanes) {
    const Grid grid{6, 4, [](double i, double j) { return Point(i, j + 0.05 * j * j, i < 3 ? 0 : i - 3); }};
    const FittedModel model = fitted(grid, {{0, 0, 3, 4}, {3, 0, 6, 4}}, {});
    const TopoDS_Shape shape = readBack(model);
    EXPECT_EQ(countSurfaces<Geom_Plane>(shape), 2);
    const FittedModel wavy = fitted(sheet(), test::tJoint(), FitOptions());
    EXPECT_EQ(countSurfaces<Geom_Plane>(readBack(wavy)), 0);
}

/// A flat sheet of N x N squares with one patch each; those at the given places have a peak in the middle.
FittedModel peaks(const std::vector<std::array<int, 2>>& places, int squaresAlong = 3) {
    const int size = 2 * squaresAlong;
    const auto isPeak = [=](double i, double j) {
        return std::ranges::any_of(places, [=](auto at) { return i == 2 * at[0] + 1 && j == 2 * at[1] + 1; });
    };
    const Grid grid{size, size, [=](double i, double j) { return Point(i, j, isPeak(i, j) ? 2 : 0); }};
    std::vector<test::Rectangle> squares;
    for (int j = 0; j < size; j += 2)
        for (int i = 0; i < size; i += 2)
            squares.push_back({i, j, i + 2, j + 2});
    return fitted(grid, squares, FitOptions());
}

ExportOptions joining() {
    ExportOptions options;
    options.join = true;
    return options;
}

TEST(MergePlanes, MakesOneFaceWithAHole) {
    const FittedModel model = peaks({{1, 1}});
    EXPECT_EQ(all(readBack(model), TopAbs_FACE).size(), 9U);
    const TopoDS_Shape shape = readBack(model, joining());
    const auto faces = all(shape, TopAbs_FACE);
    ASSERT_EQ(faces.size(), 2U);
    EXPECT_EQ(all(faces[1], TopAbs_EDGE).size(), 4U) << "the hole's";
    EXPECT_EQ(all(faces[0], TopAbs_WIRE).size(), 2U);
    EXPECT_FALSE(Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(TopoDS::Face(faces[0]))).IsNull());
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(faces[0], properties);
    EXPECT_NEAR(properties.Mass(), 32, 0.01);
    const std::string step = exportModel(model.mesh, model.layout, &model.surfaces, joining()).bytes;
    EXPECT_NE(step.find("ADVANCED_FACE('segments 0 1 2 3 5 6 7 8'"), std::string::npos);
    const ShapeReport report = *exportModel(model.mesh, model.layout, &model.surfaces, joining()).shape;
    EXPECT_EQ(report.faces, 2U);
    EXPECT_EQ(report.simpleFaces, 1U);
    EXPECT_EQ(report.openEdges + 4, report.edges);
}

TEST(MergePlanes, NamesAsManySegmentsAsFitIntoFiftyBytes) { // where Netgen keeps names
    for (const auto& [along, name] : {std::pair{4, "segments 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15"},
                                      std::pair{5, "segments 0 1 2 3 4 5 6 7 8 9 10 11 12 and 12 more"}}) {
        const FittedModel model = peaks({}, along);
        const std::string step = exportModel(model.mesh, model.layout, &model.surfaces, joining()).bytes;
        EXPECT_NE(step.find("ADVANCED_FACE('" + std::string(name) + "'"), std::string::npos) << along;
        EXPECT_LT(std::string(name).size(), 50U);
    }
}

TEST(MergePlanes, LeavesNoVertexOnAnOutlineTwice) {
    const TopoDS_Shape shape = readBack(peaks({{1, 1}, {2, 2}}), joining());
    EXPECT_EQ(countSurfaces<Geom_Plane>(shape), 2) << "the seven squares around both meet themselves";
    for (const TopoDS_Shape& face : all(shape, TopAbs_FACE))
        EXPECT_EQ(all(face, TopAbs_VERTEX).size(), all(face, TopAbs_EDGE).size());
}

ExportOptions analytic() {
    ExportOptions options;
    options.analytic = true;
    options.analyticTolerance = {0.1, true};
    return options;
}

TEST(Analytic, EdgesAreWhereSurfacesMeet) {
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

TEST(Analytic, EdgesAreLinesCirclesAndEllipses) {
    EXPECT_EQ(countCurves<Geom_Line>(readBack(bent(false, 0), analytic())), 3) << "of the bend";
    EXPECT_EQ(countCurves<Geom_Circle>(readBack(bent(true, 0), analytic())), 3);
    EXPECT_EQ(countCurves<Geom_Ellipse>(readBack(bent(true, 0.3), analytic())), 3);
    EXPECT_EQ(countCurves<Geom_Line>(readBack(bent(false, 0))), 0) << "only on request";
}

ExportOptions joiningAnalytic() {
    ExportOptions options = analytic();
    options.join = true;
    return options;
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

/// A sheet on a surface of revolution; its distance from the axis is a function of the height.
FittedModel revolved(const std::function<double(double)>& radius, bool inwards,
                     const std::vector<test::Rectangle>& rectangles = {{0, 0, 28, 16}, {28, 0, 64, 16}}) {
    const Grid grid{rectangles.back().i1, 16, [&](double i, double j) {
                        const double angle = (inwards ? -1 : 1) * 0.06 * i;
                        const double away = radius(0.2 * j);
                        return Point(7 + away * std::cos(angle), 0.2 * j - 3, away * std::sin(angle));
                    }};
    FitOptions options;
    options.tolerance.value = 0.01;
    return fitted(grid, rectangles, options);
}

TEST(QuarterTurn, NoFaceHasMoreKnotsAlongU) {
    const FittedModel model = test::torus({{0, 0, 16, 12}});
    for (const TopoDS_Shape& face : all(readBack(model), TopAbs_FACE)) {
        const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(face)));
        ASSERT_FALSE(surface.IsNull());
        EXPECT_GE(surface->NbVKnots(), surface->NbUKnots());
    }
}

TEST(Analytic, FitsMayWaveWithinTheTolerance) {
    const auto rim = [](double height) {
        return [height](double z) { return 3 + height * std::exp(-z * z / 0.09); };
    };
    ExportOptions options = analytic();
    options.analyticTolerance = {0.5, true};
    EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(readBack(revolved(rim(0.03), false), options)), 2);
    options.analyticTolerance = {3, true};
    EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(readBack(revolved(rim(0.2), false), options)), 0)
        << "this is a rim";
}

class Tori : public testing::TestWithParam<std::vector<std::array<int, 4>>> {};

TEST_P(Tori, AreToriWhereverTheyAreCut) {
    const FittedModel model = test::torus(GetParam());
    const TopoDS_Shape shape = readBack(model, analytic());
    EXPECT_EQ(countSurfaces<Geom_ToroidalSurface>(shape), static_cast<int>(all(shape, TopAbs_FACE).size()));
    EXPECT_EQ(all(shape, TopAbs_SOLID).size(), 1U);
    EXPECT_NEAR(volume(shape), 2 * std::numbers::pi * 5 * std::numbers::pi * 4, 0.2);
    for (const TopoDS_Shape& edge : all(shape, TopAbs_EDGE))
        EXPECT_LE(BRep_Tool::Tolerance(TopoDS::Edge(edge)), 1.0001e-7) << "all faces are one torus";
    EXPECT_EQ(countSurfaces<Geom_ToroidalSurface>(readBack(model)), 0) << "only on request";
}

INSTANTIATE_TEST_SUITE_P(
    All, Tori,
    testing::Values(std::vector<std::array<int, 4>>{{0, 0, 16, 12}},
                    std::vector<std::array<int, 4>>{{0, 0, 9, 12}, {9, 0, 16, 4}, {9, 4, 16, 12}},
                    std::vector<std::array<int, 4>>{{3, 5, 11, 13}, {11, 5, 19, 13}, {3, 1, 19, 5}}));

// Five rectangles around one another: no two share a whole side.
std::vector<test::Rectangle> pinwheel(int from, int to) {
    const int third = (to - from) / 3;
    return {{from, 0, to - third, 6},
            {to - third, 0, to, 10},
            {from + third, 10, to, 16},
            {from, 6, from + third, 16},
            {from + third, 6, to - third, 10}};
}

/// A tube of radius 3 and height 3.2: half of it is a pinwheel, with a bump inside the rectangle in its
/// middle, and half of it four strips.
FittedModel tube(double bump = 0) {
    auto rectangles = pinwheel(0, 24);
    for (const int from : {24, 30, 36, 42})
        rectangles.push_back({from, 0, from + 6, 16});
    const Grid grid{48, 16,
                    [bump](double i, double j) {
                        const double angle = std::numbers::pi / 24 * i;
                        const bool isInside = i > 8 && i < 16 && j > 6 && j < 10;
                        const double radius = 3 + (isInside ? bump : 0);
                        return Point(radius * std::cos(angle), radius * std::sin(angle), 0.2 * j);
                    },
                    true};
    FitOptions options;
    options.tolerance.value = 0.01;
    return fitted(grid, rectangles, options);
}

double area(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties);
    return properties.Mass();
}

TEST(MergeRuled, MakesOneFaceOfAPartOfACylinder) {
    const FittedModel model = tube();
    EXPECT_EQ(all(readBack(model, analytic()), TopAbs_FACE).size(), 9U);
    const TopoDS_Shape shape = readBack(model, joiningAnalytic());
    EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(shape), 2) << "halves, as none may meet itself";
    EXPECT_EQ(all(shape, TopAbs_FACE).size(), 2U);
    EXPECT_NEAR(area(shape), 2 * std::numbers::pi * 3 * 3.2, 0.01);
    for (const TopoDS_Shape& face : all(shape, TopAbs_FACE))
        EXPECT_NEAR(area(face), std::numbers::pi * 3 * 3.2, 0.01);
}

TEST(MergeRuled, FacesMayHaveHoles) {
    for (const double bump : {0.5, -0.5}) {
        const TopoDS_Shape shape = readBack(tube(bump), joiningAnalytic());
        EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(shape), 2);
        const auto faces = all(shape, TopAbs_FACE);
        ASSERT_EQ(faces.size(), 3U);
        EXPECT_EQ(all(faces[0], TopAbs_WIRE).size(), 2U);
        EXPECT_NEAR(area(faces[0]), 3 * (std::numbers::pi * 3.2 - std::numbers::pi / 3 * 0.8), 0.01);
    }
}

TEST(MergeRuled, WhatDoesNotGoAroundIsOneFace) {
    auto rectangles = pinwheel(0, 60);
    std::swap(rectangles[1], rectangles.back());
    const FittedModel sheet = revolved([](double) { return 3.0; }, false, rectangles);
    const TopoDS_Shape shape = readBack(sheet, joiningAnalytic());
    EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(shape), 1);
    EXPECT_EQ(all(shape, TopAbs_FACE).size(), 1U);
    EXPECT_NEAR(area(shape), 0.06 * 60 * 3 * 3.2, 0.01);
}

TEST(Analytic, EveryKindIsRecognised) {
    for (const bool inwards : {false, true}) {
        const TopoDS_Shape cylinder = readBack(revolved([](double) { return 3.0; }, inwards), analytic());
        EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(cylinder), 2) << inwards;
        const TopoDS_Shape cone =
            readBack(revolved([](double z) { return 4 - 0.5 * z; }, inwards), analytic());
        EXPECT_EQ(countSurfaces<Geom_ConicalSurface>(cone), 2) << inwards;
        const TopoDS_Shape sphere = readBack(
            revolved([](double z) { return std::sqrt(16 - (z - 1.2) * (z - 1.2)); }, inwards), analytic());
        EXPECT_EQ(countSurfaces<Geom_SphericalSurface>(sphere), 2) << inwards;
        const TopoDS_Shape none =
            readBack(revolved([](double z) { return 3 + 0.2 * std::sin(2 * z); }, inwards), analytic());
        EXPECT_EQ(countSurfaces<Geom_BSplineSurface>(none), 2) << inwards;
    }
}

TEST(Analytic, WhatBendsHardlyMoreThanItWavesIsNothing) {
    const auto bent = [](double wave) {
        return fitted(Grid{10, 10,
                           [wave](double i, double j) {
                               return Point(
                                   i, j, 0.006 * i * (10 - i) + wave * std::sin(0.4 * std::numbers::pi * j));
                           }},
                      {{0, 0, 10, 10}}, test::interpolating());
    };
    ExportOptions options = analytic();
    options.analyticTolerance = {0.35, true};
    EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(readBack(bent(0.02), options)), 1);
    EXPECT_EQ(countSurfaces<Geom_BSplineSurface>(readBack(bent(0.045), options)), 1)
        << "within the tolerance of many surfaces";
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

TEST(Analytic, ReadersFindTheWholeDistanceOfEdgesFromFaces) {
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

/// Between the origin and the faces; OpenCASCADE's own volume of an open shell depends on its vertices.
double volumeFromOrigin(const TopoDS_Shape& shape) {
    double sum = 0;
    for (const TopoDS_Shape& face : all(shape, TopAbs_FACE)) {
        BRepGProp_Face integrated(TopoDS::Face(face));
        BRepGProp_Domain domain(TopoDS::Face(face));
        sum += BRepGProp_Vinert(integrated, domain, gp_Pnt(), gp_Pnt()).Mass();
    }
    return sum;
}

TEST(Analytic, FacesLookToTheSameSideAsPatches) {
    for (const bool inwards : {false, true}) {
        const FittedModel model = revolved([](double) { return 3.0; }, inwards);
        EXPECT_NEAR(volumeFromOrigin(readBack(model)), volumeFromOrigin(readBack(model, analytic())), 1e-2);
    }
}

} // namespace
} // namespace qm
