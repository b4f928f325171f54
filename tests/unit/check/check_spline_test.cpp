// The checker's own evaluation of surfaces, and its distances.
#include "check/surfaces/bilinear_quad.h"
#include "check/surfaces/distance.h"
#include "check/surfaces/spline.h"
#include "support/polycube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <utility>

namespace qm::test {
namespace {

using namespace check;

/// A bicubic patch over [0, 2] x [0, 1] with uniform knots and control points at random.
SurfacesPart::Patch uniform(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    SurfacesPart::Patch patch;
    patch.degree = {3, 3};
    patch.count = {5, 4};
    for (int i = -3; i <= 5; ++i)
        patch.knots[0].push_back(i);
    for (int i = -3; i <= 4; ++i)
        patch.knots[1].push_back(i);
    for (int i = 0; i < 20; ++i)
        patch.controlPoints.push_back({coordinate(random), coordinate(random), coordinate(random)});
    return patch;
}

TEST(CheckSpline, HasTheWeightsOfTheUniformCubic) {
    const auto patch = uniform(1);
    // At a knot the weights are 1/6, 4/6, 1/6 in each direction.
    const std::array<double, 3> weight{1.0 / 6, 4.0 / 6, 1.0 / 6};
    std::array<double, 3> expected{};
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                expected[k] += weight[i] * weight[j] * patch.controlPoints[j * 5 + i + 1][k];
    const auto here = evaluate(patch, 1, 0);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(here.point[k], expected[k], 1e-15);
}

TEST(CheckSpline, HasTheSlopesOfItsPoints) {
    const auto patch = uniform(2);
    constexpr double h = 1e-6;
    for (const double u : {0.1, 0.5, 1.3, 1.9})
        for (const double v : {0.2, 0.7}) {
            const auto here = evaluate(patch, u, v);
            for (std::size_t k = 0; k < 3; ++k) {
                const double alongU = evaluate(patch, u + h, v).point[k] - evaluate(patch, u - h, v).point[k];
                const double alongV = evaluate(patch, u, v + h).point[k] - evaluate(patch, u, v - h).point[k];
                EXPECT_NEAR(here.alongU[k], alongU / (2 * h), 1e-7);
                EXPECT_NEAR(here.alongV[k], alongV / (2 * h), 1e-7);
            }
        }
}

TEST(CheckSpline, AgreesOnALatticeOverAPart) {
    const SurfacesPart::Patch patch = uniform(3);
    const std::vector<double> us{1.25, 1.5, 2}, vs{0, 0.75};
    const auto points = evaluateLattice(patch, us, vs);
    ASSERT_EQ(points.size(), us.size() * vs.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const SurfacePoint expected = evaluate(patch, us[k % us.size()], vs[k / us.size()]);
        EXPECT_LT(distance(points[k].point, expected.point), 1e-14);
        EXPECT_LT(distance(points[k].alongU, expected.alongU), 1e-14);
        EXPECT_LT(distance(points[k].alongV, expected.alongV), 1e-14);
    }
}

TEST(CheckSpline, ReachesTheCornersOfClampedPatches) {
    auto patch = uniform(3);
    patch.knots[0] = {0, 0, 0, 0, 0.5, 2, 2, 2, 2};
    patch.knots[1] = {0, 0, 0, 0, 1, 1, 1, 1};
    EXPECT_EQ(evaluate(patch, 0, 0).point, patch.controlPoints.front());
    EXPECT_EQ(evaluate(patch, 2, 1).point, patch.controlPoints.back());
    EXPECT_EQ(evaluate(patch, 2, 0).point, patch.controlPoints[4]);
    EXPECT_EQ(evaluate(patch, 7, -1).point, patch.controlPoints[4]);
}

TEST(CheckSpline, StandsRepeatedKnotsInside) {
    auto patch = uniform(4);
    patch.count = {7, 4};
    patch.controlPoints.resize(28, {1, 2, 3});
    patch.knots[0] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
    patch.knots[1] = {0, 0, 0, 0, 1, 1, 1, 1};
    // A triple knot of a cubic is a control point of the surface.
    EXPECT_EQ(evaluate(patch, 1, 0).point, patch.controlPoints[3]);
}

TEST(CheckDistance, ToAMeshIsThatToItsNearestFace) {
    const CheckedMesh mesh = plane({"xxxx", "xxxx"});
    const Neighbourhoods around(mesh);
    const DistanceToMesh distance(mesh, around);
    const Parameters middle{0.5, 0.5};
    LastFace last;
    EXPECT_NEAR(distance.from({3.3, 1.6, 0.25}, 0, middle, 0, last), 0.25, 1e-12);
    EXPECT_NEAR(distance.from({0.5, -0.3, 0.4}, 0, middle, 0, last), 0.5, 1e-12);
    EXPECT_NEAR(distance.from({-3, -4, 0}, 7, middle, 0, last), 5, 1e-12);
}

TEST(CheckDistance, TheSearchBeginsWhereThatBeforeItEnded) {
    const std::string row(100, 'x');
    const CheckedMesh mesh = plane({row.c_str()});
    const Neighbourhoods around(mesh);
    int searches = 0;
    const FaceSearch faces(mesh, around, [](std::size_t, const auto&) -> std::vector<Place> {
        throw std::logic_error("everything is searched");
    });
    LastFace last;
    const auto distanceTo = [&](const Place& point, int face) {
        return faces.nearest(point, face, {0.5, 0.5}, 0.5, last, [&](int near, const Parameters& from) {
            ++searches;
            return distanceToFace(mesh, near, from, point);
        });
    };
    EXPECT_NEAR(distanceTo({60.5, 0.5, 0.5}, 0), 0.5, 1e-12);
    EXPECT_EQ(last.face, 60);
    EXPECT_GE(searches, 61);
    searches = 0;
    EXPECT_NEAR(distanceTo({61.5, 0.5, 0.5}, 1), 0.5, 1e-12);
    EXPECT_EQ(last.face, 61);
    EXPECT_LE(searches, 6);
}

TEST(CheckDistance, ToABilinearFace) {
    CheckedMesh mesh = plane({"x"});
    mesh.points[2][2] = 1; // a saddle: z = x y
    const Neighbourhoods around(mesh);
    const DistanceToMesh distance(mesh, around);
    const Place middle = quadOf(mesh, 0).at(0.5, 0.5);
    EXPECT_EQ(middle, (Place{0.5, 0.5, 0.25}));
    LastFace last;
    EXPECT_NEAR(distance.from(middle, 0, {0, 0}, 0, last), 0, 1e-12);
    EXPECT_NEAR(distance.from({0.25, 0.75, 0.1875}, 0, {0.5, 0.5}, 0, last), 0, 1e-9);
}

TEST(CheckDistance, ToAPatch) {
    const auto patch = uniform(5);
    const auto here = evaluate(patch, 1.2, 0.4);
    EXPECT_NEAR(distanceToPatch(patch, {1.19, 0.41}, here.point), 0, 1e-9);
    EXPECT_LE(distanceToPatch(patch, {1.2, 0.4}, {9, 9, 9}), distance(here.point, {9, 9, 9}));
}

/// The nearest of n x n places around one, and their parameters.
std::pair<double, Parameters> nearestOfLattice(const SurfacesPart::Patch& patch, const Place& point,
                                               const Parameters& around, double halfWidth) {
    constexpr int n = 41;
    std::pair<double, Parameters> best{HUGE_VAL, {}};
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto parameter = [&](double middle, int k, double max) {
                return std::clamp(middle + halfWidth * (2.0 * k / (n - 1) - 1), 0.0, max);
            };
            const Parameters at{parameter(around[0], i, 2), parameter(around[1], j, 1)};
            best = std::min(best, {distance(evaluate(patch, at[0], at[1]).point, point), at});
        }
    return best;
}

TEST(CheckDistance, ToPatchesThatBendFarMoreThanTheirTangentsTell) {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        auto patch = uniform(seed);
        for (Place& point : patch.controlPoints)
            point[1] *= 0.02; // almost folded: its tangents are nearly parallel
        const Place point{0.3, 0.5, -0.2};
        const Parameters start = nearestOfLattice(patch, point, {1, 0.5}, 1).second;
        auto [nearest, at] = nearestOfLattice(patch, point, start, 0.1);
        for (double halfWidth = 0.02; halfWidth > 1e-8; halfWidth /= 5)
            std::tie(nearest, at) = nearestOfLattice(patch, point, at, halfWidth);
        EXPECT_LE(distanceToPatch(patch, start, point), (1 + 1e-7) * nearest) << seed;
    }
}

TEST(CheckDistance, LeavesACornerAlongEitherSide) {
    // The plane of this sheared quad has a nearest point beyond two of its sides; the quad's own lies on one.
    const CheckedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0.2, 0.6, 0}, {-0.8, 0.6, 0}}, {{0, 1, 2, 3}}};
    EXPECT_NEAR(distanceToFace(mesh, 0, {1, 1}, {0.1, 1.6, 0}), 1, 1e-12);
    const CheckedMesh mirrored{{{0, 0, 0}, {0, 1, 0}, {0.6, 0.2, 0}, {0.6, -0.8, 0}}, {{0, 1, 2, 3}}};
    EXPECT_NEAR(distanceToFace(mirrored, 0, {1, 1}, {1.6, 0.1, 0}), 1, 1e-12);
}

} // namespace
} // namespace qm::test
