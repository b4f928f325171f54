#include "base/at.h"
#include "base/error.h"
#include "basecomplex/base_complex.h"
#include "bspline/fit.h"
#include "mesh/dihedral.h"
#include "mesh/quad_geometry.h"
#include "support/grid_layout.h"
#include "view/build_scene.h"
#include "view/number_bytes.h"
#include "view/page.h"
#include "view/palette.h"
#include "view/view_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace qm {
namespace {

test::Grid sheet() {
    return {10, 8, [](double i, double j) { return Point(i + 100, j, std::sin(0.5 * i)); }};
}

/// A sheet of three segments with a T-joint and surfaces.
struct Sheet {
    QuadMesh mesh = test::makeMesh(sheet());
    Layout layout = test::makeLayout(sheet(), {{0, 0, 10, 3, 2}, {0, 3, 6, 8, 1}, {6, 3, 10, 8, 3}});
    std::vector<double> angles = dihedralAngles(mesh);
    BaseComplex complex = buildBaseComplex(mesh);
    Features features;
    Surfaces surfaces = fitSurfaces(mesh, layout, angles, {});
    double rho = 0.45;
    std::optional<TriangleSurface> scan; ///< shown on the page, if any

    [[nodiscard]] Scene scene(unsigned jobs = 1) const {
        return buildScene({.title = "sheet",
                           .kind = "surfaces",
                           .mesh = mesh,
                           .dihedralAngles = angles,
                           .baseComplex = complex,
                           .features = features,
                           .layout = &layout,
                           .surfaces = &surfaces,
                           .scan = scan ? &*scan : nullptr,
                           .tolerance = 0.02,
                           .rho = rho,
                           .maxNormalAngle = 1,
                           .unit = "cm"},
                          jobs);
    }
};

std::string pageOf(const Scene& scene, const PageOptions& options = {}) {
    return printPage({&scene, 1}, options);
}

template <class Layers> const auto& named(const Layers& layers, const std::string& name) {
    return *std::find_if(layers.begin(), layers.end(), [&](const auto& layer) { return layer.name == name; });
}

TEST(View, EveryQuadBelongsToItsSegment) {
    const Sheet sample;
    const Scene scene = sample.scene();
    const FaceLayer& segments = named(scene.faces, "segments");
    EXPECT_EQ(segments.groups.size(), 80U);
    for (std::size_t k = 0; k < sample.layout.segments.size(); ++k)
        for (const FaceId face : sample.layout.segments[k].faces)
            EXPECT_EQ(segments.groups[at(face)], k);
    EXPECT_EQ(named(scene.lines, "borders").items.count, 12U);
}

TEST(View, PatchesTravelAsControlPointsAndKnots) {
    const Sheet sample;
    const FittedPatches patches = sample.scene().patches;
    ASSERT_EQ(patches.counts.size(), 3U);
    EXPECT_EQ(patches.controlPoints.size(), 3 * controlPointCount(sample.surfaces.patches));
    EXPECT_EQ(patches.knots[1], sample.surfaces.patches[1].knots);
    EXPECT_EQ(patches.faces.size(), 80U);
}

TEST(View, DeviationIsThatWhichTheToleranceIsAbout) {
    const Sheet sample;
    const Scene scene = sample.scene();
    const Mapped& deviation = named(scene.faces, "deviation").mapped;
    const double largest = *std::max_element(deviation.values.begin(), deviation.values.end());
    EXPECT_GT(largest, 0.5 * sample.surfaces.deviation.max);
    EXPECT_LE(largest, sample.surfaces.deviation.max * 1.000001)
        << "what is certified is no less than a sample";
    EXPECT_EQ(deviation.limit, 0.02);
    EXPECT_EQ(deviation.unit, "cm");
    const FaceLayer& tolerance = named(scene.faces, "tolerance");
    EXPECT_EQ(tolerance.mapped.source, "deviation");
    EXPECT_EQ(tolerance.mapped.limit, 0.02);
}

/// Both triangles of every quad, moved up; the quads at one corner are left out.
TriangleSurface scanOf(const QuadMesh& mesh, double above) {
    Triangles triangles;
    for (const VertexId vertex : mesh.vertices())
        triangles.points.push_back(mesh.point(vertex) + Point(0, 0, above));
    for (const FaceId face : mesh.faces()) {
        const auto corners = cornersOf(mesh, face);
        if (face.idx() == 0) continue;
        for (const std::size_t k : {1U, 2U})
            triangles.faces.push_back({corners[0].idx(), corners[k].idx(), corners[k + 1].idx()});
    }
    return TriangleSurface(triangles);
}

TEST(View, SurfacesThatWereFittedToAScanAreComparedWithIt) {
    constexpr double above = 0.05;
    Sheet sample;
    const TriangleSurface scan = scanOf(sample.mesh, above);
    const double fromMesh = named(sample.scene().faces, "deviation").mapped.values.at(40);
    sample.surfaces = fitSurfaces(sample.mesh, sample.layout, sample.angles, {}, &scan);
    sample.scan = scanOf(sample.mesh, above);
    const Scene scene = sample.scene();
    const Mapped& deviation = named(scene.faces, "deviation").mapped;
    EXPECT_LE(*std::ranges::max_element(deviation.values), sample.surfaces.deviation.max * 1.000001);
    EXPECT_NEAR(deviation.values.at(40), fromMesh, 0.5 * above);
    EXPECT_NE(deviation.quantity.find("from the scan"), std::string::npos);
    const auto& fromScan = named(scene.faces, "scan").mapped.values;
    EXPECT_EQ(fromScan.size(), deviation.values.size());
    float max = 0;
    for (const float distance : fromScan)
        max = std::max(max, distance);
    EXPECT_NEAR(max, sample.surfaces.scan->max, 0.3 * sample.surfaces.scan->max);
    EXPECT_GT(std::ranges::count_if(fromScan, [](float value) { return std::isnan(value); }), 0)
        << "the scan has a hole";
}

TEST(View, WithoutTheScanPatchesHaveTheirLargestDeviation) {
    Sheet sample;
    const TriangleSurface scan = scanOf(sample.mesh, 0.05);
    sample.surfaces = fitSurfaces(sample.mesh, sample.layout, sample.angles, {}, &scan);
    const Scene scene = sample.scene();
    const auto& values = named(scene.faces, "deviation").mapped.values;
    EXPECT_FLOAT_EQ(values.front(), static_cast<float>(sample.surfaces.ofPatch.front().max));
    EXPECT_FLOAT_EQ(values.back(), static_cast<float>(sample.surfaces.ofPatch.back().max));
    sample.scan = scanOf(sample.mesh, 0.05);
    EXPECT_EQ(values.size(), named(sample.scene().faces, "deviation").mapped.values.size());
    EXPECT_TRUE(std::ranges::none_of(scene.faces, [](const auto& layer) { return layer.name == "scan"; }));
}

TEST(View, NormalsAreComparedAcrossSmoothBordersOnly) {
    const Sheet sample;
    const Scene scene = sample.scene();
    const LineLayer& jumps = named(scene.lines, "jumps");
    // The borders between the segments have 10 edges along one line and 5 along another.
    EXPECT_EQ(jumps.items.count, 15U);
    for (const float angle : jumps.items.columns.back().values) {
        EXPECT_GE(angle, 0);
        EXPECT_LE(angle, sample.surfaces.deviation.largestNormalAngle + 1e-6);
    }
    Sheet creased;
    creased.rho = 0;
    const Scene others = creased.scene();
    EXPECT_LT(named(others.lines, "jumps").items.count, 15U);
}

TEST(View, BordersOfPatchesRunOnTheirLattice) {
    const Sheet sample;
    const Scene scene = sample.scene();
    const LineLayer& curves = named(scene.lines, "curves");
    ASSERT_EQ(curves.items.count, 12U);
    const auto side = [&](std::size_t item) {
        return std::pair(curves.points[curves.starts[item]], curves.points[curves.starts[item + 1] - 1]);
    };
    for (std::size_t patch = 0; patch < 3; ++patch)
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_EQ(side(4 * patch + k).second, side(4 * patch + (k + 1) % 4).first) << "they close";
    const std::size_t steps = scene.patches.steps;
    EXPECT_EQ(curves.starts[1], 10 * steps + 1);
    EXPECT_EQ(side(4).first, (10 * steps + 1) * (3 * steps + 1)) << "the second patch begins after the first";
}

TEST(View, StripesAreOnSurfacesAndMesh) {
    const Scene scene = Sheet().scene();
    EXPECT_EQ(named(scene.faces, "zebra").base, Base::surfaces);
    EXPECT_EQ(named(scene.faces, "mesh-zebra").base, Base::mesh);
}

TEST(View, IsCentredAndDoesNotDependOnThreads) {
    const Sheet sample;
    const Scene scene = sample.scene();
    for (const float coordinate : scene.mesh.positions)
        EXPECT_LE(std::abs(coordinate), scene.radius);
    EXPECT_EQ(pageOf(scene), pageOf(sample.scene(3)));
}

TEST(View, AllLayersAreKnownByName) {
    const auto known = allLayerNames();
    const auto expectKnown = [&](const auto& layers) {
        for (const auto& layer : layers)
            EXPECT_NE(std::find(known.begin(), known.end(), layer.name), known.end()) << layer.name;
    };
    const Scene scene = Sheet().scene();
    expectKnown(scene.faces);
    expectKnown(scene.lines);
    expectKnown(scene.points);
}

TEST(View, TwoScenesNeedTheLayersOfEither) {
    const Sheet sample;
    std::vector<Scene> scenes = {sample.scene(), sample.scene()};
    scenes[0].faces.resize(2); // mesh and stripes only
    PageOptions options;
    options.shown = {"zebra"};
    EXPECT_NO_THROW((void)printPage(scenes, options));
    options.shown = {"cuts"};
    EXPECT_THROW((void)printPage(scenes, options), Error);
}

TEST(View, ThePageIsWholeAndRefusesUnknownLayers) {
    const Scene scene = Sheet().scene();
    const std::string page = pageOf(scene);
    EXPECT_TRUE(page.starts_with("<!doctype html>"));
    EXPECT_EQ(page.find("{{"), std::string::npos) << "every place is filled";
    PageOptions options;
    options.shown = {"segments", "net"};
    EXPECT_NO_THROW((void)pageOf(scene, options));
    options.shown = {"segments", "mesh"};
    EXPECT_THROW((void)pageOf(scene, options), Error);
    options.shown = {"cuts"};
    EXPECT_THROW((void)pageOf(scene, options), Error);
}

TEST(View, TitlesCannotEndTheScene) {
    Scene scene = Sheet().scene();
    scene.title = "</script><script>alert(1)</script>";
    EXPECT_EQ(pageOf(scene).find("<script>alert"), std::string::npos);
}

TEST(View, NeighboursDifferInColour) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ring;
    for (std::uint32_t k = 0; k < 101; ++k)
        ring.emplace_back(k, (k + 1) % 101);
    const auto colours = colourNumbers(101, ring);
    for (const auto& [a, b] : ring)
        EXPECT_NE(colours[a], colours[b]);
    for (const std::uint32_t colour : colours)
        EXPECT_LT(colour, colourCount);
    EXPECT_EQ(colourNumbers(1, {{0, 0}}).size(), 1U);
}

TEST(View, Base64IsTheStandards) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    const std::string large(7 << 20, 'a');
    EXPECT_EQ(base64(large).size(), (large.size() + 2) / 3 * 4) << "no padding inside";
    EXPECT_EQ(base64(large).find('='), base64(large).size() - 1 - (large.size() % 3 == 1 ? 1 : 0));
}

TEST(View, NumbersAreFewBytes) {
    EXPECT_EQ(differenceBytes({0, -1, 0, 63, 127, 255}), std::string("\x00\x01\x02\x7e\x80\x01\x80\x02", 8));
    EXPECT_EQ(differenceBytes({0xffffffff}), "\xfe\xff\xff\xff\x1f");
    const RoughNumbers rough = roughNumbers({0, 1, 2});
    EXPECT_EQ(rough.bytes, std::string("\x00\x00\xff\x7f\xfe\xff", 6));
    EXPECT_DOUBLE_EQ(rough.unit * 65534, 2);
    EXPECT_EQ(roughNumbers({std::nanf(""), 1}).bytes, "\xff\xff\xfe\xff");
    EXPECT_EQ(roughNumbers({0, 0}).bytes, std::string(4, '\0'));
    EXPECT_EQ(roughNumbers({INFINITY, 0}).bytes, std::string("\xfe\xff\0\0", 4));
    EXPECT_EQ(floatBytes({1}), std::string("\x00\x00\x80\x3f", 4));
}

TEST(View, OptionsAreRead) {
    EXPECT_FALSE(parseSection(""));
    EXPECT_EQ(parseSection("y")->axis, 1U);
    EXPECT_EQ(parseSection("z:0.25")->share, 0.25);
    for (const char* bad : {"a", ":0.5", "x:2", "x:-1", "x:0.5:1", "xy", "x:nan", "x:"})
        EXPECT_THROW((void)parseSection(bad), Error) << bad;
    EXPECT_EQ(parseLayers("mesh,tracks,,net"), (std::vector<std::string>{"mesh", "tracks", "net"}));
    EXPECT_EQ(parseLayers("mesh,net,mesh"), (std::vector<std::string>{"mesh", "net"}));
    EXPECT_EQ(parseLayers(""), std::vector<std::string>{});
    EXPECT_THROW((void)parseLayers("mesh,foo"), Error);
    EXPECT_EQ(parseDirection("1,-2,0.5"), (std::array<double, 3>{1, -2, 0.5}));
    EXPECT_EQ(parseSize("640x480").width, 640);
    for (const char* bad : {"", "640", "640x", "x480", "640x480x2", "1x1", "99999x2", "640 x 480"})
        EXPECT_THROW((void)parseSize(bad), Error) << bad;
    for (const char* bad : {"", "1,2", "1,2,3,4", "0,0,0", "a,b,c", "1,2,nan", "1e-200,0,0", "1e300,1,1"})
        EXPECT_THROW((void)parseDirection(bad), Error) << bad;
}

} // namespace
} // namespace qm
