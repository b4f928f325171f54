#include "base/at.h"
#include "bspline/fit.h"
#include "bspline/fitting/fit_options.h"
#include "bspline/splines/evaluate.h"
#include "mesh/bounding_box.h"
#include "mesh/dihedral.h"
#include "shape/scan.h"
#include "shape/shape.h"
#include "support/cheapest_layout.h"
#include "support/true_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace qm {
namespace {

class NoisyScan : public ::testing::TestWithParam<const char*> {};

TEST_P(NoisyScan, IsFartherFromTheTruthThanTheSurfacesFittedToIt) {
    const std::string name = GetParam();
    const auto truth = test::trueSurface(name);
    ASSERT_TRUE(truth);
    const QuadMesh mesh = makeShape(name);
    const std::vector<double> angles = dihedralAngles(mesh);
    const Layout layout = test::cheapestLayout(mesh);
    Triangles scan = makeScan(name, 60'000);
    addNoise(scan, 0.0005 * boundingBoxOf(scan.points).diagonal(), 3);
    double ofScan = 0;
    for (const Point& point : scan.points)
        ofScan += std::pow(truth->nearest(point).distance, 2);
    ofScan = std::sqrt(ofScan / static_cast<double>(scan.points.size()));

    const TriangleSurface surface(scan);
    const Surfaces surfaces = fitSurfaces(mesh, layout, angles, {}, &surface);
    ASSERT_TRUE(surfaces.scan);
    EXPECT_GT(surfaces.scan->coverage, 0.95);
    double sum = 0;
    double count = 0;
    for (const Patch& patch : surfaces.patches) {
        const auto& size = layout.segments[at(patch.segment.value())].size;
        for (int j = 0; j <= 3 * size[1]; ++j)
            for (int i = 0; i <= 3 * size[0]; ++i) {
                sum += std::pow(truth->nearest(evaluate(patch, i / 3.0, j / 3.0).position).distance, 2);
                ++count;
            }
    }
    RecordProperty("gain", std::to_string(ofScan / std::sqrt(sum / count)));
    EXPECT_LT(std::sqrt(sum / count), ofScan / 2);
}

INSTANTIATE_TEST_SUITE_P(Parts, NoisyScan,
                         ::testing::Values("sphere", "torus", "block", "plate", "genus3", "tube"));

std::size_t controlPointsFor(const QuadMesh& mesh, const Triangles& scan) {
    const std::vector<double> angles = dihedralAngles(mesh);
    const TriangleSurface surface(scan);
    const Surfaces surfaces = fitSurfaces(mesh, test::cheapestLayout(mesh), angles, {}, &surface);
    EXPECT_LE(surfaces.deviation.maxRelative, 0.001);
    return controlPointCount(surfaces.patches);
}

TEST(DirtyScan, IsGivenUpWhereOnlyNoiseIsLeftToFollow) {
    // About two triangles a quad, so that noise cannot be told from the shape.
    const QuadMesh mesh = makeShape("torus", {.around = 24});
    Triangles scan = makeScan("torus", 2 * static_cast<double>(mesh.n_faces()));
    addNoise(scan, 0.01 * boundingBoxOf(scan.points).diagonal(), 1);
    const TriangleSurface surface(scan);
    const FitOptions options{.tolerance = {0.02, true}, .rho = 0.2};
    int rounds = 0;
    int questions = 0; // one in every round, and one whenever folded patches begin anew
    Control control;
    control.progress = [&](double) { ++rounds; };
    control.stopRequested = [&] { return ++questions < 0; };
    const Surfaces surfaces =
        fitSurfaces(mesh, test::cheapestLayout(mesh), dihedralAngles(mesh), options, &surface, control);
    EXPECT_FALSE(missedTolerance(surfaces, options).empty());
    EXPECT_LT(rounds, 10);
    EXPECT_LT(questions, 10 + SmoothFitOptions{}.unfoldings) << "it is not begun once more";
}

TEST(Scan, IsGivenUpWhereItIsSharpAndSurfacesMustBeSmooth) {
    // A restart begins with more control points than the first attempt was allowed.
    const ShapeOptions shape{.resolution = 2, .seed = 29, .voxels = 2};
    const QuadMesh mesh = makeShape("random-open", shape);
    const TriangleSurface surface(makeScan("random-open", 300, shape));
    const FitOptions options{.rho = 1.9};
    int questions = 0; // as above, in all attempts
    Control control;
    control.stopRequested = [&] { return ++questions < 0; };
    const Surfaces surfaces =
        fitSurfaces(mesh, test::cheapestLayout(mesh), dihedralAngles(mesh), options, &surface, control);
    EXPECT_FALSE(missedTolerance(surfaces, options).empty());
    EXPECT_LT(questions, SmoothFitOptions{}.maxRounds) << "more would be rounds of a second attempt";
}

TEST(DirtyScan, NoiseIsNotFollowedWhereTrianglesAreNoSmallerThanSteps) {
    const QuadMesh mesh = makeShape("block");
    Triangles scan = makeScan("block", 6 * static_cast<double>(mesh.n_faces()));
    const std::size_t expected = controlPointsFor(mesh, scan);
    addNoise(scan, 0.0005 * boundingBoxOf(scan.points).diagonal(), 1);
    const TriangleSurface surface(scan);
    const Surfaces surfaces =
        fitSurfaces(mesh, test::cheapestLayout(mesh), dihedralAngles(mesh), {}, &surface);
    EXPECT_EQ(missedTolerance(surfaces, {}), "");
    EXPECT_LE(controlPointCount(surfaces.patches), 2 * expected);
}

TEST(DirtyScan, NeedsFewMoreControlPointsThanACleanOne) {
    const QuadMesh mesh = makeShape("block");
    const Triangles clean = makeScan("block", 60'000);
    const std::size_t expected = controlPointsFor(mesh, clean);

    Triangles torn{clean.points, {}};
    const double radius = 0.08 * boundingBoxOf(clean.points).diagonal();
    const Point middle = clean.points[clean.points.size() / 3];
    for (const auto& face : clean.faces)
        if ((clean.points[at(face[0])] - middle).norm() > radius) torn.faces.push_back(face);
    EXPECT_LE(controlPointsFor(mesh, torn), 1.2 * static_cast<double>(expected));

    Triangles spiked = clean;
    const Triangles noise = [&] {
        Triangles all = clean;
        addNoise(all, 0.01 * boundingBoxOf(clean.points).diagonal(), 1);
        return all;
    }();
    for (std::size_t k = 0; k < spiked.points.size(); k += 100)
        spiked.points[k] = noise.points[k];
    EXPECT_LE(controlPointsFor(mesh, spiked), 3 * static_cast<double>(expected));
}

} // namespace
} // namespace qm
