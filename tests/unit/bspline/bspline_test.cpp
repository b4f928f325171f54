#include "bspline/splines/basis.h"
#include "bspline/splines/evaluate.h"
#include "bspline/splines/spline_curve.h"
#include "support/steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace qm {
namespace {

std::vector<double> uniform() {
    return {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6};
}
std::vector<double> clamped() {
    return {0, 0, 0, 0, 1, 2, 2, 2, 3.5, 5, 5, 5, 5};
}
std::vector<double> halfClamped() {
    return {0, 0, 0, 0, 1, 3, 4, 5, 6};
}

TEST(Basis, FindsTheSpan) {
    EXPECT_EQ(knotSpan(uniform(), 3, 0), 3U);
    EXPECT_EQ(knotSpan(uniform(), 3, 0.99), 3U);
    EXPECT_EQ(knotSpan(uniform(), 3, 1), 4U);
    EXPECT_EQ(knotSpan(uniform(), 3, 3), 5U) << "the end belongs to the last interval";
    EXPECT_EQ(knotSpan(uniform(), 3, -7), 3U);
    EXPECT_EQ(knotSpan(uniform(), 3, 7), 5U);
    EXPECT_EQ(knotSpan(clamped(), 3, 0), 3U);
    EXPECT_EQ(knotSpan(clamped(), 3, 2), 7U) << "behind all three equal knots";
    EXPECT_EQ(knotSpan(clamped(), 3, 5), 8U);
}

TEST(Basis, SumsToOneAndItsDerivativeToZero) {
    for (const auto& knots : {uniform(), clamped(), halfClamped()}) {
        const auto [low, high] = domain(knots, 3);
        for (const double t : test::steps(low, high, (high - low) / 97)) {
            const BasisValues b = basisValues(knots, 3, t);
            EXPECT_NEAR(std::accumulate(b.value.begin(), b.value.end(), 0.0), 1, 1e-14);
            EXPECT_NEAR(std::accumulate(b.derivative.begin(), b.derivative.end(), 0.0), 0, 1e-13);
        }
    }
}

TEST(Basis, ReproducesCubicsThroughTheirBlossom) {
    // The control point of basis function k is the blossom at the knots k + 1, k + 2, k + 3.
    for (const auto& t : {uniform(), clamped(), halfClamped()}) {
        const auto [low, high] = domain(t, 3);
        for (const double x : test::steps(low, high, (high - low) / 41)) {
            const BasisValues b = basisValues(t, 3, x);
            double value = 0;
            double derivative = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t n = b.first + k;
                value += b.value[k] * t[n + 1] * t[n + 2] * t[n + 3];
                derivative += b.derivative[k] * t[n + 1] * t[n + 2] * t[n + 3];
            }
            EXPECT_NEAR(value, x * x * x, 1e-11);
            EXPECT_NEAR(derivative, 3 * x * x, 1e-11);
        }
    }
}

TEST(Basis, KnowsOtherDegrees) {
    const std::vector<double> knots = {0, 0, 1, 2, 2};
    const BasisValues hat = basisValues(knots, 1, 0.25);
    EXPECT_EQ(hat.first, 0U);
    EXPECT_DOUBLE_EQ(hat.value[0], 0.75);
    EXPECT_DOUBLE_EQ(hat.value[1], 0.25);
    EXPECT_DOUBLE_EQ(hat.derivative[1], 1);
    EXPECT_DOUBLE_EQ(basisValues({{0.0, 1.0}}, 0, 0.5).value[0], 1);
}

/// Degrees 3 and 2, knots of both kinds.
Patch samplePatch() {
    Patch patch;
    patch.degree = {3, 2};
    patch.knots = {halfClamped(), {0, 0, 0, 0.5, 2, 2, 2}};
    patch.count = {5, 4};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 5; ++i)
            patch.controlPoints.emplace_back(i + 0.1 * j * j, j - 0.2 * i, std::sin(i + 2.0 * j));
    return patch;
}

TEST(Evaluate, HasDerivativesThatAgreeWithDifferences) {
    const Patch patch = samplePatch();
    EXPECT_EQ(domain(patch)[0], (std::array{0.0, 3.0}));
    EXPECT_EQ(domain(patch)[1], (std::array{0.0, 2.0}));
    const double h = 1e-6;
    for (const double u : {0.1, 0.9, 2.5})
        for (const double v : {0.2, 0.7, 1.9}) {
            const SurfacePoint at = evaluate(patch, u, v);
            const Point du =
                (evaluate(patch, u + h, v).position - evaluate(patch, u - h, v).position) / (2 * h);
            const Point dv =
                (evaluate(patch, u, v + h).position - evaluate(patch, u, v - h).position) / (2 * h);
            EXPECT_LT((at.du - du).norm(), 1e-8);
            EXPECT_LT((at.dv - dv).norm(), 1e-8);
        }
}

TEST(Evaluate, AgreesOnALattice) {
    const Patch patch = samplePatch();
    const std::vector<double> us = {0, 0.4, 1, 3};
    const std::vector<double> vs = {0, 0.5, 2};
    const auto points = evaluateLattice(patch, us, vs);
    ASSERT_EQ(points.size(), 12U);
    const auto positions = positionLattice(patch, basisTable(patch.knots[0], patch.degree[0], us),
                                           basisTable(patch.knots[1], patch.degree[1], vs));
    for (std::size_t j = 0; j < vs.size(); ++j)
        for (std::size_t i = 0; i < us.size(); ++i) {
            const SurfacePoint expected = evaluate(patch, us[i], vs[j]);
            const SurfacePoint& point = points[j * us.size() + i];
            EXPECT_LT((point.position - expected.position).norm(), 1e-14);
            EXPECT_LT((point.du - expected.du).norm(), 1e-14);
            EXPECT_LT((point.dv - expected.dv).norm(), 1e-14);
            EXPECT_EQ(point.position, positions[j * us.size() + i]);
        }
}

TEST(Evaluate, NormalsPointToTheSideOfTheFaces) {
    EXPECT_EQ(unitNormal({2, 0, 0}, {1, 3, 0}), Point(0, 0, 1));
    EXPECT_EQ(unitNormal({2, 0, 0}, {4, 0, 0}), std::nullopt) << "degenerate";
    EXPECT_EQ(unitNormal({0, 0, 0}, {4, 0, 0}), std::nullopt);
}

TEST(SplineCurve, IsTheSameAfterRestrictionReversalAndRefinement) {
    const SplineCurve curve{
        {0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5},
        {{0, 0, 0}, {1, 2, 0}, {2, 1, 1}, {4, 0, 3}, {5, 5, 1}, {7, 4, 0}, {8, 2, 2}, {9, 3, 1}}};
    const SplineCurve part = restricted(curve, 1, 4);
    EXPECT_EQ(part.length(), 3);
    EXPECT_EQ(part.points.size(), 6U);
    const SplineCurve back = reversed(part);
    const SplineCurve fine = withKnots(part, {0, 0, 0, 0, 0.5, 1, 1, 1, 1.25, 2, 2, 3, 3, 3, 3});
    EXPECT_EQ(fine.points.size(), 11U);
    for (const double t : test::steps(0, 3, 0.0625)) {
        const Point expected = evaluate(curve, 1 + t);
        EXPECT_LT((evaluate(part, t) - expected).norm(), 1e-13) << t;
        EXPECT_LT((evaluate(back, 3 - t) - expected).norm(), 1e-13) << t;
        EXPECT_LT((evaluate(fine, t) - expected).norm(), 1e-13) << t;
    }
}

TEST(SplineCurve, IsTheSameInALowerDegree) {
    const std::vector<Point> points = {{0, 0, 0}, {1, 3, -1}, {4, 1, 2}};
    const SplineCurve parabola = bezier(points, 5);
    EXPECT_EQ(parabola.degree, 2);
    for (const double t : {0.0, 0.3, 0.5, 1.0}) {
        const Point expected =
            (1 - t) * (1 - t) * points[0] + 2 * t * (1 - t) * points[1] + t * t * points[2];
        EXPECT_LT((evaluate(parabola, 5 * t) - expected).norm(), 1e-14);
    }
    EXPECT_LT((degreeReduced(parabola, 2)[1] - points[1]).norm(), 1e-14);
    const SplineCurve line = bezier(std::vector<Point>{points[0], points[2]}, 2);
    EXPECT_EQ(line.degree, 1);
    EXPECT_LT((evaluate(line, 0.5) - 0.25 * points[2]).norm(), 1e-14);
    EXPECT_LT((degreeReduced(line, 2)[1] - 0.5 * points[2]).norm(), 1e-14);
    EXPECT_EQ(restricted(parabola, 1, 2).degree, 2);
}

TEST(SplineCurve, JoinsWithACorner) {
    const SplineCurve first = bezier(std::vector<Point>{{0, 0, 0}, {1, 2, 0}, {2, 1, 1}, {4, 0, 3}}, 2);
    const SplineCurve second = bezier(std::vector<Point>{{4, 0, 3}, {5, 5, 1}, {7, 4, 0}, {8, 2, 2}}, 3);
    const std::vector<SplineCurve> parts = {first, second};
    const SplineCurve whole = joined(parts);
    EXPECT_EQ(whole.knots.size(), whole.points.size() + 4);
    EXPECT_EQ(std::count(whole.knots.begin(), whole.knots.end(), 2.0), 3);
    for (const double t : test::steps(0, 5, 0.125))
        EXPECT_LT((evaluate(whole, t) - (t < 2 ? evaluate(first, t) : evaluate(second, t - 2))).norm(),
                  1e-14);
}

} // namespace
} // namespace qm
