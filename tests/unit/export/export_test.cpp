#include "base/bytes.h"
#include "base/error.h"
#include "bspline/fit.h"
#include "bspline/splines/clamped_patch.h"
#include "bspline/splines/evaluate.h"
#include "export/export.h"
#include "export/faces/face_patches.h"
#include "export/files/shape.h"
#include "mesh/bounding_box.h"
#include "support/exported_shape.h"

#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Reader.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <regex>
#include <tuple>

namespace qm {
namespace {

using test::fitted;
using test::glued;
using test::Grid;
using test::readStep;
using test::sheet;
using test::tJoint;
using test::torus;
using Model = test::FittedModel;

struct Made {
    TopoDS_Shape shape;
    ShapeReport report;
};

/// Makes the shape of a model as qm-export does.
Made shapeOf(const Model& model) {
    const FacePatches faces = separated(model.mesh, facePatches(model.layout, model.surfaces.patches), 1e-9);
    return {buildShape(makeBoundary(model.mesh, faces)).shape,
            *exportModel(model.mesh, model.layout, &model.surfaces, {}).shape};
}

TEST(ClampedPatch, IsTheSameSurface) {
    const Model model = fitted(sheet(), tJoint(), {});
    const Patch& patch = model.surfaces.patches[1];
    const Patch clampedPatch = clamped(patch);
    EXPECT_EQ(clampedPatch.count, patch.count);
    EXPECT_EQ(clampedPatch.knots[0][0], 0);
    EXPECT_EQ(clampedPatch.knots[0][3], 0);
    for (const double u : {0.0, 0.5, 2.75, 5.0})
        for (const double v : {0.0, 0.2, 3.0, 6.0})
            EXPECT_LT((evaluate(clampedPatch, u, v).position - evaluate(patch, u, v).position).norm(), 1e-13);
    EXPECT_EQ(clamped(clampedPatch).controlPoints, clampedPatch.controlPoints);
    const SplineCurve side = borderCurve(clampedPatch, 2);
    EXPECT_LT((evaluate(side, 1.5) - evaluate(patch, 5 - 1.5, 6).position).norm(), 1e-13);
}

TEST(Shape, IsAnOpenShellWithSharedEdges) {
    const Model model = fitted(sheet(), tJoint(), FitOptions());
    const Made shape = shapeOf(model);
    EXPECT_TRUE(shape.report.valid);
    EXPECT_EQ(shape.report.faces, 3U);
    EXPECT_EQ(shape.report.edges, 10U) << "the long side is two edges on the other side of the T-joint";
    EXPECT_EQ(shape.report.openEdges, 7U);
    EXPECT_EQ(shape.report.shells, 1U);
    EXPECT_EQ(shape.report.solids, 0U);
    EXPECT_LT(shape.report.largestTolerance, 1e-6);
    EXPECT_EQ(shape.shape.ShapeType(), TopAbs_SHELL);
}

TEST(Shape, BridgesTheGapsOfIndependentPatchesByTolerance) {
    const Model model = fitted(sheet(), tJoint(), test::interpolating());
    const Made shape = shapeOf(model);
    EXPECT_TRUE(shape.report.valid);
    EXPECT_EQ(shape.report.edges, 10U);
    EXPECT_GE(shape.report.largestTolerance, model.surfaces.deviation.largestGap);
    EXPECT_LT(shape.report.largestTolerance, 4 * model.surfaces.deviation.largestGap);
}

TEST(Shape, IsASolidIfTheMeshIsClosed) {
    const double expected = 2 * std::numbers::pi * 5 * std::numbers::pi * 4;
    for (const auto& rectangles :
         std::vector<std::vector<std::array<int, 4>>>{{{0, 0, 16, 12}},
                                                      {{0, 0, 16, 5}, {0, 5, 16, 12}},
                                                      {{0, 0, 9, 12}, {9, 0, 16, 4}, {9, 4, 16, 12}}}) {
        const Model model = torus(rectangles);
        const Made shape = shapeOf(model);
        EXPECT_TRUE(shape.report.valid);
        EXPECT_EQ(shape.report.solids, 1U);
        EXPECT_EQ(shape.report.openEdges, 0U);
        GProp_GProps volume;
        BRepGProp::VolumeProperties(shape.shape, volume);
        EXPECT_NEAR(volume.Mass(), expected, 0.01 * expected) << "and not inside out";
    }
}

TEST(Shape, TakesPatchesOfLowerDegrees) {
    const Grid ruled{10, 8, [](double i, double j) { return Point(i, j, std::sin(0.5 * i)); }};
    Model model = fitted(ruled, {{0, 0, 10, 8}}, test::interpolating());
    // Also those between the two curves that the others lie between.
    for (Patch& patch : model.surfaces.patches) {
        patch = clamped(patch);
        const auto columns = static_cast<std::ptrdiff_t>(patch.count[0]);
        const double length = patch.knots[1].back();
        patch.controlPoints.erase(patch.controlPoints.begin() + columns, patch.controlPoints.end() - columns);
        patch.degree[1] = 1;
        patch.count[1] = 2;
        patch.knots[1] = {0, 0, length, length};
    }
    const Made made = shapeOf(model);
    EXPECT_TRUE(made.report.valid);
    EXPECT_LT(made.report.largestTolerance, 1e-6);
}

TEST(FacePatches, RefusePatchesThatDoNotBelong) {
    Model model = fitted(sheet(), tJoint(), test::interpolating());
    auto patches = model.surfaces.patches;
    patches.pop_back();
    EXPECT_THROW((void)facePatches(model.layout, patches), Error);
    patches = model.surfaces.patches;
    std::swap(patches[0], patches[1]);
    EXPECT_THROW((void)facePatches(model.layout, patches), Error);
    patches = model.surfaces.patches;
    patches[2].controlPoints.pop_back();
    EXPECT_THROW((void)facePatches(model.layout, patches), Error);
    patches = model.surfaces.patches;
    patches[2].degree = {2, 3};
    EXPECT_THROW((void)facePatches(model.layout, patches), Error);
    patches = model.surfaces.patches;
    patches[2].knots[1].clear();
    EXPECT_THROW((void)facePatches(model.layout, patches), Error);
    for (const std::size_t first : {2U, 4U}) {
        patches = model.surfaces.patches;
        auto& knots = patches[2].knots[0];
        ASSERT_GE(knots.size(), 11U);
        std::fill_n(knots.begin() + static_cast<std::ptrdiff_t>(first), 4, knots[first]);
        EXPECT_THROW((void)facePatches(model.layout, patches), Error) << first;
    }
}

std::size_t countShapes(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
    std::size_t count = 0;
    for (TopExp_Explorer explorer(shape, type); explorer.More(); explorer.Next())
        ++count;
    return count;
}

std::string exported(const Model& model, ExportFormat format, const ExportOptions& more = {}) {
    ExportOptions options = more;
    options.format = format;
    return exportModel(model.mesh, model.layout, &model.surfaces, options).bytes;
}

TopoDS_Shape readIges(const std::string& text) {
    const auto path = std::filesystem::temp_directory_path() / "quadmesh-export-test.iges";
    std::ofstream(path) << text;
    IGESControl_Reader reader;
    EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
    reader.TransferRoots();
    std::filesystem::remove(path);
    return reader.OneShape();
}

TEST(Step, IsReadBackAsTheSameSolid) {
    const Model model = torus({{0, 0, 9, 12}, {9, 0, 16, 4}, {9, 4, 16, 12}});
    const std::string text = exported(model, ExportFormat::step);
    const TopoDS_Shape shape = readStep(text);
    EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
    EXPECT_EQ(countShapes(shape, TopAbs_FACE), 4U) << "the first patch meets itself and is cut";
    EXPECT_EQ(countShapes(shape, TopAbs_SOLID), 1U);
}

TEST(Step, IsReadBackFarFromTheOrigin) {
    Model model = glued(test::loop(), 0);
    for (const VertexId vertex : model.mesh.vertices())
        model.mesh.point(vertex) += Point(4.5e6, 5e6, 0);
    for (Point& point : model.surfaces.patches[0].controlPoints)
        point += Point(4.5e6, 5e6, 0);
    const Made made = shapeOf(model);
    EXPECT_TRUE(made.report.valid);
    EXPECT_LT(made.report.largestTolerance, 1e-4);
    EXPECT_TRUE(BRepCheck_Analyzer(readStep(exported(model, ExportFormat::step))).IsValid());
}

class Contacts : public testing::TestWithParam<std::tuple<Grid (*)(), int>> {};

TEST_P(Contacts, AreBetweenFacesAndNeverWithinOne) {
    const auto& [grid, turned] = GetParam();
    const Model model = glued(grid(), turned);
    const Made made = shapeOf(model);
    EXPECT_TRUE(made.report.valid);
    EXPECT_GT(made.report.faces, 1U);
    for (const TopoDS_Shape& shape :
         {readStep(exported(model, ExportFormat::step)), readIges(exported(model, ExportFormat::iges))}) {
        EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
        EXPECT_EQ(countShapes(shape, TopAbs_FACE), made.report.faces);
        for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
            TopTools_IndexedMapOfShape edges;
            TopTools_IndexedMapOfShape vertices;
            TopExp::MapShapes(face.Current(), TopAbs_EDGE, edges);
            TopExp::MapShapes(face.Current(), TopAbs_VERTEX, vertices);
            EXPECT_EQ(countShapes(face.Current(), TopAbs_EDGE), static_cast<std::size_t>(edges.Extent()));
            EXPECT_EQ(vertices.Extent(), edges.Extent()) << "every vertex once";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Turned, Contacts,
                         testing::Combine(testing::Values(&test::loop, &test::helix, &test::pocket),
                                          testing::Range(0, 4)));

TEST(Step, NamesFacesAndDeclaresTheUnitWithoutConverting) {
    const Model model = fitted(sheet(), tJoint(), test::interpolating());
    const std::string millimetres = exported(model, ExportFormat::step);
    for (const char* name :
         {"ADVANCED_FACE('segment 0'", "ADVANCED_FACE('segment 1'", "ADVANCED_FACE('segment 2'"})
        EXPECT_NE(millimetres.find(name), std::string::npos) << name;
    EXPECT_NE(millimetres.find("AUTOMOTIVE_DESIGN"), std::string::npos);
    EXPECT_NE(millimetres.find("SI_UNIT(.MILLI.,.METRE.)"), std::string::npos);
    ExportOptions options;
    options.unit = LengthUnit::inch;
    const std::string inches = exported(model, ExportFormat::step, options);
    EXPECT_NE(inches.find("CONVERSION_BASED_UNIT('INCH'"), std::string::npos);
    const auto controlPoint = [](const std::string& text) {
        std::smatch match;
        EXPECT_TRUE(
            std::regex_search(text, match, std::regex("CARTESIAN_POINT\\('',\\(10\\.,8\\.,[^)]*\\)\\)")));
        return match.str();
    };
    EXPECT_EQ(controlPoint(millimetres), controlPoint(inches)) << "the corner of the sheet";
}

/// The first name of an entity of this type.
std::string nameOf(const std::string& step, const std::string& entity) {
    std::smatch match;
    EXPECT_TRUE(std::regex_search(step, match, std::regex(entity + "\\('([^']*)'"))) << entity;
    return match[1];
}

TEST(Step, HasNamesThatFitIntoFiftyBytes) { // where Netgen keeps them
    const Model model = torus({{0, 0, 16, 12}});
    ExportOptions options;
    options.name = std::string(48, 'x') + "\u00e9" + std::string(48, 'y');
    const std::string step = exportModel(model.mesh, model.layout, &model.surfaces, options).bytes;
    EXPECT_EQ(nameOf(step, "MANIFOLD_SOLID_BREP"), std::string(48, 'x'));
    EXPECT_EQ(nameOf(step, "[^_]PRODUCT"), std::string(48, 'x') + "\\X2\\00E9\\X0\\" + std::string(48, 'y'));
}

TEST(Step, IsTheSameEveryTime) {
    const Model model = fitted(sheet(), tJoint(), FitOptions());
    EXPECT_EQ(exported(model, ExportFormat::step), exported(model, ExportFormat::step));
    EXPECT_EQ(exported(model, ExportFormat::iges), exported(model, ExportFormat::iges));
}

TEST(Iges, WritesAnUnderscoreForEveryForeignLetter) {
    ExportOptions options;
    options.name = "pi\u00e8ce \u96f6\u4ef6";
    const std::string text = exported(fitted(sheet(), tJoint(), {}), ExportFormat::iges, options);
    EXPECT_NE(text.find("8Hpi_ce __,"), std::string::npos) << text.substr(0, 400);
}

TEST(Iges, IsReadBackWithAllFaces) {
    const Model model = fitted(sheet(), tJoint(), FitOptions());
    const std::string text = exported(model, ExportFormat::iges);
    EXPECT_NE(text.find("S2"), std::string::npos);
    const TopoDS_Shape shape = readIges(text);
    EXPECT_EQ(countShapes(shape, TopAbs_FACE), 3U);
    EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
}

class Units : public testing::TestWithParam<LengthUnit> {};

TEST_P(Units, AreDeclaredAndNothingIsConverted) {
    const Grid grid{1, 1, [](double i, double j) { return Point(12.5 * i, 37.5 * j, 0); }};
    const Model model = fitted(grid, {{0, 0, 1, 1}}, test::interpolating());
    ExportOptions options;
    options.unit = GetParam();
    const std::string step = exported(model, ExportFormat::step, options);
    EXPECT_NE(step.find("CARTESIAN_POINT('',(12.5,37.5,0.))"), std::string::npos);
    const std::string iges = exported(model, ExportFormat::iges, options);
    EXPECT_NE(iges.find("12.5,37.5,0."), std::string::npos);
    switch (GetParam()) {
    case LengthUnit::mm:
        EXPECT_NE(iges.find(",2,2HMM,"), std::string::npos);
        EXPECT_NE(step.find("SI_UNIT(.MILLI.,.METRE.)"), std::string::npos);
        break;
    case LengthUnit::cm:
        EXPECT_NE(iges.find(",10,2HCM,"), std::string::npos);
        EXPECT_NE(step.find("SI_UNIT(.CENTI.,.METRE.)"), std::string::npos);
        break;
    case LengthUnit::m:
        EXPECT_NE(iges.find(",6,1HM,"), std::string::npos);
        EXPECT_NE(step.find("SI_UNIT($,.METRE.)"), std::string::npos);
        break;
    case LengthUnit::inch:
        EXPECT_NE(iges.find(",1,4HINCH,"), std::string::npos);
        EXPECT_NE(step.find("CONVERSION_BASED_UNIT('INCH'"), std::string::npos);
        break;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Units,
                         testing::Values(LengthUnit::mm, LengthUnit::cm, LengthUnit::m, LengthUnit::inch));

TEST(Obj, HasTheMeshInOneGroupPerSegment) {
    const Grid grid{2, 1, [](double i, double j) { return Point(i, 0.1 * j, -2.5); }};
    const Model model = fitted(grid, {{0, 0, 1, 1}, {1, 0, 2, 1}}, {});
    EXPECT_EQ(exported(model, ExportFormat::obj), "v 0 0 -2.5\nv 1 0 -2.5\nv 2 0 -2.5\n"
                                                  "v 0 0.1 -2.5\nv 1 0.1 -2.5\nv 2 0.1 -2.5\n"
                                                  "g segment_0\nf 1 2 5 4\ng segment_1\nf 2 3 6 5\n");
}

template <class Number> Number numberAt(const std::string& bytes, std::size_t offset) {
    Number number;
    std::memcpy(&number, bytes.data() + offset, sizeof number);
    return number;
}

TEST(Ply, HasColoursAndSegments) {
    const Model model = fitted(sheet(), tJoint(), {});
    const std::string bytes = exported(model, ExportFormat::ply);
    const std::string end = "end_header\n";
    const std::size_t header = bytes.find(end) + end.size();
    const std::size_t faces = header + 24 * model.mesh.n_vertices();
    constexpr std::size_t faceSize = 1 + 16 + 3 + 4;
    ASSERT_EQ(bytes.size(), faces + faceSize * model.mesh.n_faces());
    EXPECT_EQ(numberAt<double>(bytes, header + std::size_t{24} * 13 + 8), model.mesh.point(VertexId(13))[1]);
    std::array<int, 3> count{};
    std::array<std::string, 3> colours;
    for (std::size_t f = 0; f < model.mesh.n_faces(); ++f) {
        const std::size_t at = faces + f * faceSize;
        EXPECT_EQ(bytes[at], 4);
        const auto segment = static_cast<std::size_t>(numberAt<std::int32_t>(bytes, at + 20));
        ++count.at(segment);
        const std::string colour = bytes.substr(at + 17, 3);
        EXPECT_TRUE(colours[segment].empty() || colours[segment] == colour);
        colours[segment] = colour;
    }
    EXPECT_EQ(count, (std::array{30, 30, 20}));
    EXPECT_NE(colours[0], colours[1]);
    EXPECT_NE(colours[1], colours[2]);
}

TEST(Ply, ColoursByDeviationFromBlueToRed) {
    Model model = fitted(sheet(), tJoint(), {});
    model.surfaces.deviation.max = 4;
    model.surfaces.ofPatch[0].max = 4;
    model.surfaces.ofPatch[1].max = 0;
    model.surfaces.ofPatch[2].max = 2;
    ExportOptions options;
    options.colour = ColourBy::deviation;
    const std::string bytes = exported(model, ExportFormat::ply, options);
    const std::size_t faces = bytes.find("end_header\n") + 11 + 24 * model.mesh.n_vertices();
    const auto colourOf = [&](std::size_t face) { return bytes.substr(faces + face * 24 + 17, 3); };
    EXPECT_EQ(colourOf(0), std::string("\xff\0\0", 3));
    EXPECT_EQ(colourOf(30), std::string("\0\0\xff", 3));
    EXPECT_EQ(colourOf(36), std::string("\0\xff\0", 3));
}

TEST(Glb, IsWellFormed) {
    const Model model = fitted(sheet(), tJoint(), {});
    const std::string bytes = exported(model, ExportFormat::glb);
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(numberAt<std::uint32_t>(bytes, 4), 2U);
    EXPECT_EQ(numberAt<std::uint32_t>(bytes, 8), bytes.size());
    const std::uint32_t json = numberAt<std::uint32_t>(bytes, 12);
    EXPECT_EQ(json % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    const std::string text = bytes.substr(20, json);
    EXPECT_NE(text.find(R"("name":"segment 2")"), std::string::npos);
    EXPECT_EQ(std::count(text.begin(), text.end(), '{'), std::count(text.begin(), text.end(), '}'));
    const std::uint32_t binary = numberAt<std::uint32_t>(bytes, 20 + json);
    EXPECT_EQ(bytes.substr(20 + json + 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(bytes.size(), 20 + json + 8 + binary);
    constexpr std::size_t vertices = 11 * 4 + 7 * 6 + 5 * 6;
    EXPECT_EQ(binary, vertices * (12 + 12 + 4) + model.mesh.n_faces() * 24);
    EXPECT_NE(text.find(R"("byteLength":)" + std::to_string(binary) + "}]"), std::string::npos);
}

TEST(Glb, ColoursAreLinear) {
    const std::string bytes = exported(fitted(sheet(), tJoint(), {}), ExportFormat::glb);
    const std::uint32_t json = numberAt<std::uint32_t>(bytes, 12);
    constexpr std::size_t vertices = 11 * 4 + 7 * 6 + 5 * 6;
    // The first colour is 242, 109, 109 in sRGB.
    EXPECT_EQ(bytes.substr(20 + json + 8 + vertices * 24, 4), "\xe2\x27\x27\xff");
}

TEST(Glb, CoordinatesFarFromTheOriginBeginAtTheCentre) {
    Model model = fitted(sheet(), tJoint(), {});
    const auto positions = [&] {
        const std::string bytes = exported(model, ExportFormat::glb);
        const std::uint32_t json = numberAt<std::uint32_t>(bytes, 12);
        std::vector<float> result;
        constexpr std::size_t row = 11;
        for (std::size_t k = 0; k < 3 * row; ++k)
            result.push_back(numberAt<float>(bytes, 20 + json + 8 + 4 * k));
        return std::pair(bytes.substr(20, json), result);
    };
    const auto [plainText, plain] = positions();
    EXPECT_EQ(plainText.find("translation"), std::string::npos);
    const Point away(1 << 20, 0, 0);
    for (const VertexId vertex : model.mesh.vertices())
        model.mesh.point(vertex) += away;
    const Point centre = boundingBox(model.mesh).centre() - away;
    const auto [text, moved] = positions();
    EXPECT_NE(text.find(R"("scenes":[{"nodes":[3]}])"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("children":[0,1,2])"), std::string::npos);
    EXPECT_NE(text.find(R"("translation":[10485)"), std::string::npos);
    for (std::size_t k = 0; k < plain.size(); ++k)
        EXPECT_NEAR(moved[k] + centre[static_cast<unsigned>(k % 3)], plain[k], 1e-6);
}

TEST(Glb, RefusesWhatSinglePrecisionCannotHold) {
    Model model = fitted(sheet(), tJoint(), {});
    model.mesh.point(VertexId(0))[0] = -1e39;
    EXPECT_THROW((void)exported(model, ExportFormat::glb), Error);
}

TEST(Export, AsksForSurfacesWhereItNeedsThem) {
    const Model model = fitted(sheet(), tJoint(), {});
    ExportOptions options;
    EXPECT_THROW((void)exportModel(model.mesh, model.layout, nullptr, options), Error);
    options.format = ExportFormat::glb;
    EXPECT_FALSE(exportModel(model.mesh, model.layout, nullptr, options).bytes.empty());
    options.colour = ColourBy::deviation;
    EXPECT_THROW((void)exportModel(model.mesh, model.layout, nullptr, options), Error);
}

TEST(Export, RefusesWhatOpenCascadeRefuses) {
    Model model = fitted(sheet(), tJoint(), {});
    auto& knots = model.surfaces.patches[1].knots[0];
    ASSERT_LT(knots[4], knots[5]);
    knots[5] = std::nextafter(knots[4], knots[5]);
    EXPECT_THROW((void)exported(model, ExportFormat::step), Error);
}

} // namespace
} // namespace qm
