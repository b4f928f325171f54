#include "base/error.h"
#include "basecomplex/base_complex.h"
#include "bspline/fit.h"
#include "mesh/dihedral.h"
#include "support/grid_layout.h"
#include "view/base64.h"
#include "view/build_scene.h"
#include "view/page.h"
#include "view/palette.h"
#include "view/view_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

const test::Grid sheet{10, 8, [](double i, double j) { return Point(i + 100, j, std::sin(0.5 * i)); }};

/// A sheet of three segments with a T-joint, with its surfaces.
struct Sheet {
    QuadMesh mesh = test::makeMesh(sheet);
    Layout layout = test::makeLayout(sheet, {{0, 0, 10, 3, 2}, {0, 3, 6, 8, 1}, {6, 3, 10, 8, 3}});
    std::vector<double> angles = dihedralAngles(mesh);
    BaseComplex complex = buildBaseComplex(mesh);
    Features features;
    Surfaces surfaces = fitSurfaces(mesh, layout, angles, {});

    [[nodiscard]] Scene scene(unsigned jobs = 1) const {
        return buildScene(
            {"sheet", "surfaces", mesh, angles, complex, features, nullptr, nullptr, &layout, &surfaces},
            jobs);
    }
};

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
            EXPECT_EQ(segments.groups[static_cast<std::size_t>(face.idx())], k);
    EXPECT_EQ(named(scene.lines, "borders").items.count, 12U);
}

TEST(View, SamplesLieOnThePatchesAndNameTheirFace) {
    const Sheet sample;
    const Scene scene = sample.scene();
    const Shell& shell = scene.shells[static_cast<std::size_t>(Base::surfaces)];
    ASSERT_EQ(shell.quads.size(), 4 * shell.faces.size());
    ASSERT_EQ(shell.faces.size() % 80, 0U) << "as many samples for every quad";
    const Shell& mesh = scene.shells[static_cast<std::size_t>(Base::mesh)];
    for (std::size_t k = 0; k < shell.faces.size(); ++k) {
        Point sampled(0, 0, 0), quad(0, 0, 0);
        for (std::size_t corner = 0; corner < 4; ++corner)
            for (unsigned d = 0; d < 3; ++d) {
                sampled[d] += shell.positions[3 * shell.quads[4 * k + corner] + d] / 4;
                quad[d] += mesh.positions[3 * mesh.quads[4 * shell.faces[k] + corner] + d] / 4;
            }
        EXPECT_LT((sampled - quad).norm(), 0.8) << "inside the unit quad it belongs to";
    }
    const FaceLayer& deviation = named(scene.faces, "deviation");
    EXPECT_EQ(3 * deviation.values.size(), shell.positions.size());
    EXPECT_LE(deviation.scale, 1.001 * sample.surfaces.deviation.max + 0.05);
    EXPECT_GT(deviation.scale, 0);
}

TEST(View, IsCentredAndDoesNotDependOnThreads) {
    const Sheet sample;
    const Scene scene = sample.scene();
    for (const float coordinate : scene.shells[0].positions)
        EXPECT_LE(std::abs(coordinate), scene.radius);
    EXPECT_EQ(printPage(scene, {}), printPage(sample.scene(3), {}));
}

TEST(View, ThePageIsWholeAndRefusesUnknownLayers) {
    const Scene scene = Sheet().scene();
    const std::string page = printPage(scene, {});
    EXPECT_TRUE(page.starts_with("<!doctype html>"));
    EXPECT_EQ(page.find("{{"), std::string::npos) << "every place is filled";
    PageOptions options;
    options.shown = {"segments", "net"};
    EXPECT_NO_THROW((void)printPage(scene, options));
    options.shown = {"segments", "mesh"};
    EXPECT_THROW((void)printPage(scene, options), Error);
    options.shown = {"cuts"};
    EXPECT_THROW((void)printPage(scene, options), Error);
}

TEST(View, TitlesCannotEndTheScene) {
    Scene scene = Sheet().scene();
    scene.title = "</script><script>alert(1)</script>";
    EXPECT_EQ(printPage(scene, {}).find("<script>alert"), std::string::npos);
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

TEST(View, OptionsAreRead) {
    EXPECT_EQ(parseNames("a,b,,c"), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_EQ(parseDirection("1,-2,0.5"), (std::array<double, 3>{1, -2, 0.5}));
    EXPECT_EQ(parseSize("640x480").width, 640);
    for (const char* bad : {"", "640", "640x", "x480", "640x480x2", "1x1", "99999x2", "640 x 480"})
        EXPECT_THROW((void)parseSize(bad), Error) << bad;
    for (const char* bad : {"", "1,2", "1,2,3,4", "0,0,0", "a,b,c", "1,2,nan"})
        EXPECT_THROW((void)parseDirection(bad), Error) << bad;
}

} // namespace
} // namespace qm
