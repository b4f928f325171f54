#include "base/error.h"
#include "bspline/agreed_normals.h"
#include "bspline/border_curves.h"
#include "bspline/border_normals.h"
#include "bspline/borders.h"
#include "bspline/deviation_samples.h"
#include "bspline/evaluate.h"
#include "bspline/fit.h"
#include "bspline/knot_refinement.h"
#include "bspline/patch_smoothing.h"
#include "bspline/tolerance.h"
#include "support/grid_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

using test::Grid;

const Grid hills{24, 16, [](double i, double j) {
                     return Point(i + 0.2 * std::sin(j), j, 1.5 * std::sin(0.5 * i) * std::cos(0.4 * j));
                 }};
// With T-joints, and turned in every way.
const std::vector<test::Rectangle> tiles = {
    {0, 0, 14, 6, 1}, {14, 0, 24, 10, 2}, {9, 10, 24, 16, 3}, {0, 6, 9, 16, 0}, {9, 6, 14, 10, 1}};

class Kinks : public testing::Test {
protected:
    [[nodiscard]] Surfaces fit(double maxKink, double budget, unsigned jobs = 1) const {
        FitOptions options;
        options.fit = Fit::tolerance;
        options.tolerance = {0.08, false};
        options.maxKink = maxKink;
        options.kinkBudget = budget;
        Control control;
        control.jobs = jobs;
        return fitSurfaces(mesh, layout, angles, options, control);
    }

    QuadMesh mesh = test::makeMesh(hills);
    Layout layout = test::makeLayout(hills, tiles);
    std::vector<double> angles = std::vector<double>(mesh.n_edges(), 0.1);
};

TEST_F(Kinks, ShrinkWithoutMoreControlPointsAndMoreSoWithSome) {
    const Surfaces rough = fit(180, 0);
    const Surfaces agreed = fit(0.5, 0);
    const Surfaces smooth = fit(0.5, 1);
    EXPECT_GT(rough.deviation.rmsKink, 1) << "else there is nothing to show";
    EXPECT_LT(agreed.deviation.rmsKink, 0.9 * rough.deviation.rmsKink);
    EXPECT_LT(smooth.deviation.rmsKink, 0.4 * rough.deviation.rmsKink);
    EXPECT_LT(smooth.deviation.largestKink, rough.deviation.largestKink);
    EXPECT_LE(controlPointCount(agreed.patches), controlPointCount(rough.patches));
    EXPECT_GT(controlPointCount(smooth.patches), controlPointCount(rough.patches));
    for (const Surfaces& surfaces : {rough, agreed, smooth}) {
        EXPECT_LE(surfaces.deviation.max, 0.08);
        EXPECT_LT(surfaces.deviation.largestGapRelative, 1e-11);
    }
}

TEST_F(Kinks, CurvesMeetInOnePlaneWhereTheBudgetAllows) {
    const auto atCorners = [&](const Surfaces& surfaces) {
        double most = 0;
        for (const BorderEdge& border : borderEdges(mesh, layout))
            for (const double end : {0.0, 1.0})
                if (border.places.size() == 2)
                    most = std::max(most, kink(meeting(border, layout, surfaces.patches, end)));
        return most;
    };
    const double rough = atCorners(fit(180, 0));
    EXPECT_GT(rough, 3) << "else there is nothing to show";
    EXPECT_LT(atCorners(fit(0.5, 2)), 0.5 * rough);
}

TEST_F(Kinks, StayWithinTheBudget) {
    const std::size_t least = controlPointCount(fit(180, 0).patches);
    const std::size_t interpolated = controlPointCount(fitSurfaces(mesh, layout, angles, {}).patches);
    const double budget = static_cast<double>(least + 40) / static_cast<double>(interpolated);
    const Surfaces surfaces = fit(0.1, budget);
    EXPECT_LE(controlPointCount(surfaces.patches), least + 40);
    EXPECT_GT(controlPointCount(surfaces.patches), least);
    EXPECT_LT(surfaces.deviation.rmsKink, fit(0.1, 0).deviation.rmsKink);
}

TEST_F(Kinks, DoNotDependOnTheNumberOfThreads) {
    const Surfaces one = fit(0.5, 1, 1);
    const Surfaces four = fit(0.5, 1, 4);
    for (std::size_t s = 0; s < one.patches.size(); ++s)
        EXPECT_EQ(one.patches[s].controlPoints, four.patches[s].controlPoints);
}

TEST_F(Kinks, AreLeftOnFeatures) {
    angles.assign(mesh.n_edges(), 1.5);
    const Surfaces surfaces = fit(0.5, 1);
    EXPECT_EQ(controlPointCount(surfaces.patches), controlPointCount(fit(180, 0).patches));
    EXPECT_EQ(surfaces.deviation.largestKink, 0);
}

TEST_F(Kinks, RefuseLimitsThatMakeNoSense) {
    EXPECT_THROW(fit(-1, 0.5), Error);
    EXPECT_THROW(fit(std::nan(""), 0.5), Error);
    EXPECT_THROW(fit(1, -0.1), Error);
    EXPECT_THROW(fit(1, 11), Error);
}

/// Two flat patches that meet in a roof of known slopes.
TEST(AgreedNormals, AreInTheMiddleBetweenNeighbours) {
    const Grid roof{6, 2, [](double i, double j) { return Point(i, j, i < 3 ? 0 : 0.2 * (i - 3)); }};
    const QuadMesh mesh = test::makeMesh(roof);
    const Layout layout = test::makeLayout(roof, {{0, 0, 3, 2, 1}, {3, 0, 6, 2, 2}});
    const std::vector<double> angles(mesh.n_edges(), 0.1);
    const ToleranceFit fit(mesh, layout, angles, 0.45, 1e-6, 0.15, 1000, 1);
    AgreedNormals agreed(fit.curves());
    for (std::size_t k = 0; k < 2; ++k)
        agreed.update(k, fit.patches()[k]);
    const double slope = std::atan(0.2);
    for (std::size_t k = 0; k < 2; ++k) {
        const auto kinks = agreed.kinks(k);
        ASSERT_EQ(kinks.size(), normalParameters(2).size()) << "the boundary of the mesh has none";
        for (const double kink : kinks)
            EXPECT_NEAR(kink, slope * 180 / std::numbers::pi, 0.1);
        std::size_t prescribed = 0;
        for (const auto& ofDirection : agreed.of(k))
            for (const auto& normals : ofDirection)
                for (const Point& normal : normals) {
                    if (normal.sqrnorm() == 0) continue;
                    ++prescribed;
                    EXPECT_GT(normal | Point(-std::sin(slope / 2), 0, std::cos(slope / 2)), 0.99999);
                }
        EXPECT_EQ(prescribed, kinks.size());
    }
}

/// A flat patch over [0, 6] x [0, 4], asked to lean along its lower border.
PatchFitInput leaning(double angle) {
    PatchFitInput input;
    input.size = {6, 4};
    for (int j = 0; j <= 4; ++j)
        for (int i = 0; i <= 6; ++i)
            input.grid.emplace_back(i, j, 0);
    input.closeness.assign(input.grid.size(), {});
    const auto line = [](const Point& from, const Point& to, double length) {
        SplineCurve curve;
        curve.knots = bareKnots(length);
        for (const double share : {0.0, 1.0, 2.0, 3.0})
            curve.points.push_back(from + share / 3 * (to - from));
        return curve;
    };
    input.border = {{{line({0, 0, 0}, {6, 0, 0}, 6), line({0, 4, 0}, {6, 4, 0}, 6)},
                     {line({0, 0, 0}, {0, 4, 0}, 4), line({6, 0, 0}, {6, 4, 0}, 4)}}};
    for (std::size_t d = 0; d < 2; ++d)
        for (auto& normals : input.normals[d])
            normals.assign(normalParameters(input.size[d]).size(), Point(0, 0, 0));
    for (Point& normal : input.normals[0][0])
        normal = {0, -std::sin(angle), std::cos(angle)};
    return input;
}

TEST(PatchSmoothing, TurnsAPatchAndAddsAKnotOnlyIfAllowed) {
    const double tolerance = 0.05;
    PatchFitInput upright = leaning(0);
    const Patch flat = fitPatch(upright, tolerance);
    ASSERT_LT(normalErrors(upright, flat).largest, 1e-6);
    const PatchFitInput input = leaning(0.2);
    const NormalErrors before = normalErrors(input, flat);
    EXPECT_NEAR(before.largest, 0.2 * 180 / std::numbers::pi, 1e-3);
    const SmoothedPatch still = smoothPatch(input, tolerance, flat, 90, true);
    EXPECT_FALSE(still.sameKnots || still.oneMoreKnot);

    Patch patch = flat;
    double squares = before.squares;
    for (int round = 0; round < 6; ++round) {
        const SmoothedPatch fixed = smoothPatch(input, tolerance, patch, 1, false);
        EXPECT_FALSE(fixed.oneMoreKnot);
        if (fixed.sameKnots) {
            EXPECT_EQ(fixed.sameKnots->knots, patch.knots);
        }
        const SmoothedPatch grown = smoothPatch(input, tolerance, patch, 1, true);
        if (!grown.oneMoreKnot) break;
        EXPECT_GT(grown.oneMoreKnot->controlPoints.size(), patch.controlPoints.size());
        EXPECT_GT(grown.gain, 0);
        patch = *grown.oneMoreKnot;
        EXPECT_LT(normalErrors(input, patch).squares, squares);
        squares = normalErrors(input, patch).squares;
        for (double v = 0; v <= 4; v += 0.25)
            for (double u = 0; u <= 6; u += 0.25)
                EXPECT_LT(std::abs(evaluate(patch, u, v).position[2]), 1.1 * tolerance);
    }
    EXPECT_LT(squares, 0.25 * before.squares);
}

TEST(BorderNormals, LieOnTheSidesTheyNameInTheirDirections) {
    const PatchFitInput input = leaning(0);
    Patch patch = fitPatch(input, 0.05);
    const auto angles = anglesOff(input.normals, input.border, patch);
    for (const auto& ofDirection : angles)
        for (const auto& ofEnd : ofDirection)
            for (const double angle : ofEnd)
                EXPECT_NEAR(angle, 0, 1e-9) << "no normal prescribed, or the patch's own";
    EXPECT_EQ(normalsOnBorder(patch, 0, 1).size(), normalParameters(6).size());
    EXPECT_EQ(normalsOnBorder(patch, 1, 0).size(), normalParameters(4).size());
    EXPECT_EQ(unitNormalAcross({0, 0, 2}, {1, 0, 0}), Point(0, 0, 1));
    EXPECT_EQ(unitNormalAcross({1, 0, 0}, {1, 0, 0}), Point(0, 0, 0));
    EXPECT_EQ(angleInDegrees({-1, 0, 0}, {0, 0, 0}), 0) << "not half a turn for the sign of a zero";
}

} // namespace
} // namespace qm
