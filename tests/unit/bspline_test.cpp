#include "bspline/basis.h"
#include "bspline/evaluate.h"
#include "bspline/patch_equations.h"
#include "bspline/patch_frame.h"
#include "bspline/profile_factor.h"
#include "bspline/spline_curve.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace qm {
namespace {

const std::vector<double> uniform = {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6};
const std::vector<double> clamped = {0, 0, 0, 0, 1, 2, 2, 2, 3.5, 5, 5, 5, 5};
const std::vector<double> halfClamped = {0, 0, 0, 0, 1, 3, 4, 5, 6};

TEST(Basis, FindsTheSpan) {
    EXPECT_EQ(knotSpan(uniform, 3, 0), 3U);
    EXPECT_EQ(knotSpan(uniform, 3, 0.99), 3U);
    EXPECT_EQ(knotSpan(uniform, 3, 1), 4U);
    EXPECT_EQ(knotSpan(uniform, 3, 3), 5U) << "the end belongs to the last interval";
    EXPECT_EQ(knotSpan(uniform, 3, -7), 3U);
    EXPECT_EQ(knotSpan(uniform, 3, 7), 5U);
    EXPECT_EQ(knotSpan(clamped, 3, 0), 3U);
    EXPECT_EQ(knotSpan(clamped, 3, 2), 7U) << "behind all three equal knots";
    EXPECT_EQ(knotSpan(clamped, 3, 5), 8U);
}

TEST(Basis, SumsToOneAndItsDerivativeToZero) {
    for (const auto* knots : {&uniform, &clamped, &halfClamped}) {
        const auto [low, high] = domain(*knots, 3);
        for (double t = low; t <= high; t += (high - low) / 97) {
            const BasisValues b = basisValues(*knots, 3, t);
            EXPECT_NEAR(std::accumulate(b.value.begin(), b.value.end(), 0.0), 1, 1e-14);
            EXPECT_NEAR(std::accumulate(b.derivative.begin(), b.derivative.end(), 0.0), 0, 1e-13);
        }
    }
}

TEST(Basis, ReproducesCubicsThroughTheirBlossom) {
    // The control point of basis function k is the blossom at the knots k + 1, k + 2, k + 3.
    for (const auto* knots : {&uniform, &clamped, &halfClamped}) {
        const auto& t = *knots;
        const auto [low, high] = domain(t, 3);
        for (double x = low; x <= high; x += (high - low) / 41) {
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
    patch.knots = {halfClamped, {0, 0, 0, 0.5, 2, 2, 2}};
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

/// Terms of every kind, for patches that are wide, high, and of lower degree.
TEST(PatchEquations, SolveALatticeAsPointByPoint) {
    const std::vector<double> longer = {0, 0, 0, 0, 1, 1.5, 2, 2, 3, 5, 6, 6, 6, 6};
    const std::vector<double> shorter = {0, 0, 0, 0, 1, 2, 2, 2, 2};
    const std::vector<double> quadratic = {0, 0, 0, 3, 3, 3};
    for (const auto& [knotsU, knotsV] : {std::pair(longer, shorter), std::pair(shorter, longer),
                                         std::pair(quadratic, longer), std::pair(longer, quadratic)}) {
        Patch frame = emptyPatch(knotsU, knotsV);
        double at = 0;
        for (Point& point : frame.controlPoints) { // the inner ones do not count
            at += 1;
            point = {std::sin(3 * at), std::cos(5 * at), std::sin(7 * at)};
        }
        std::array<std::vector<BasisValues>, 2> tables;
        for (std::size_t d = 0; d < 2; ++d) {
            std::vector<double> parameters;
            for (double t = 0; t <= frame.knots[d].back(); t += 0.25)
                parameters.push_back(t);
            tables[d] = basisTable(frame.knots[d], frame.degree[d], parameters);
        }
        PatchEquations points(frame);
        PatchEquations lattice(frame);
        std::vector<double> weights;
        std::vector<Eigen::Matrix3d> metrics;
        std::vector<Point> targets;
        for (const BasisValues& v : tables[1])
            for (const BasisValues& u : tables[0]) {
                const auto k = static_cast<double>(weights.size());
                const Eigen::Vector3d normal(std::sin(k), 1, std::cos(k));
                weights.push_back(1 + 0.5 * std::sin(k));
                metrics.emplace_back(0.1 * Eigen::Matrix3d::Identity() + normal * normal.transpose());
                targets.emplace_back(std::cos(0.3 * k), std::sin(0.1 * k), 0.01 * k);
                points.add(valueWeights(u), valueWeights(v), weights.back() * metrics.back(), targets.back());
            }
        lattice.addLattice(tables[0], tables[1], weights, metrics, targets);
        const Patch expected = points.solve();
        const Patch found = lattice.solve();
        for (std::size_t k = 0; k < expected.controlPoints.size(); ++k)
            EXPECT_LT((found.controlPoints[k] - expected.controlPoints[k]).norm(), 1e-10);
    }
}

TEST(Evaluate, NormalsPointToTheSideOfTheFaces) {
    EXPECT_EQ(unitNormal({2, 0, 0}, {1, 3, 0}), Point(0, 0, 1));
    EXPECT_EQ(unitNormal({2, 0, 0}, {4, 0, 0}), Point(0, 0, 0)) << "degenerate";
    EXPECT_EQ(unitNormal({0, 0, 0}, {4, 0, 0}), Point(0, 0, 0));
    EXPECT_NEAR(angleInDegrees({0, 0, 1}, {0, 1, 0}), 90, 1e-12);
    EXPECT_EQ(angleInDegrees({0, 0, 1}, {0, 0, 0}), 0);
}

const std::vector<Point> bends = {{0, 0, 0}, {1, 2, 0}, {2, 1, 1}, {4, 0, 3}, {5, 5, 1}, {7, 4, 0}};

TEST(SplineCurve, InterpolatesWithTheSlopesAtItsEnds) {
    const SplineCurve curve = interpolateClamped(bends, {1, 1, 0}, {0, 2, 0});
    ASSERT_EQ(curve.points.size(), 8U);
    ASSERT_EQ(curve.knots.size(), 12U);
    EXPECT_EQ(curve.length(), 5);
    for (std::size_t k = 0; k < bends.size(); ++k)
        EXPECT_LT((evaluate(curve, static_cast<double>(k)) - bends[k]).norm(), 1e-14);
    EXPECT_LT((3.0 * (curve.points[1] - curve.points[0]) - Point(1, 1, 0)).norm(), 1e-14);
    EXPECT_LT((3.0 * (curve.points[7] - curve.points[6]) - Point(0, 2, 0)).norm(), 1e-14);
}

TEST(SplineCurve, InterpolatesTwoPoints) {
    const SplineCurve curve =
        interpolateClamped(std::vector<Point>{{0, 0, 0}, {3, 0, 0}}, {3, 0, 0}, {3, 0, 0});
    EXPECT_LT((evaluate(curve, 0.25) - Point(0.75, 0, 0)).norm(), 1e-15);
}

TEST(SplineCurve, IsTheSameAfterRestrictionReversalAndRefinement) {
    const SplineCurve curve = interpolateClamped(bends, {1, 1, 0}, {0, 2, 0});
    const SplineCurve part = restricted(curve, 1, 4);
    EXPECT_EQ(part.length(), 3);
    EXPECT_EQ(part.points.size(), 6U);
    const SplineCurve back = reversed(part);
    const SplineCurve fine = withKnots(part, {0, 0, 0, 0, 0.5, 1, 1, 1, 1.25, 2, 2, 3, 3, 3, 3});
    EXPECT_EQ(fine.points.size(), 11U);
    for (double t = 0; t <= 3; t += 0.0625) {
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
    EXPECT_LT((lowered(parabola, 2)[1] - points[1]).norm(), 1e-14);
    const SplineCurve line = bezier(std::vector<Point>{points[0], points[2]}, 2);
    EXPECT_EQ(line.degree, 1);
    EXPECT_LT((evaluate(line, 0.5) - 0.25 * points[2]).norm(), 1e-14);
    EXPECT_LT((lowered(line, 2)[1] - 0.5 * points[2]).norm(), 1e-14);
    EXPECT_EQ(restricted(parabola, 1, 2).degree, 2);
    const std::vector<SplineCurve> both = {line, line};
    EXPECT_EQ(joined(both).degree, 3);
}

TEST(ProfileFactor, SolvesQuasiDefiniteSystems) {
    // Two unknowns with an equation between them, then a third unknown.
    ProfileFactor matrix({0, 0, 0, 2});
    matrix.at(0, 0) = 2;
    matrix.at(1, 0) = 1;
    matrix.at(1, 1) = 3;
    matrix.at(2, 0) = 1;
    matrix.at(2, 1) = -1;
    matrix.at(2, 2) = -0.5;
    matrix.at(3, 2) = 4;
    matrix.at(3, 3) = 1;
    Eigen::Matrix4d full;
    full << 2, 1, 1, 0, 1, 3, -1, 0, 1, -1, -0.5, 4, 0, 0, 4, 1;
    const Eigen::Vector4d solution(1, -2, 0.5, 3);
    matrix.factorise();
    EXPECT_LT((matrix.solve(full * solution) - solution).norm(), 1e-13);
}

TEST(SplineCurve, JoinsWithACorner) {
    const SplineCurve first =
        interpolateClamped(std::vector<Point>(bends.begin(), bends.begin() + 3), {1, 1, 0}, {5, 0, 0});
    const SplineCurve second =
        interpolateClamped(std::vector<Point>(bends.begin() + 2, bends.end()), {0, 0, 5}, {0, 2, 0});
    const std::vector<SplineCurve> parts = {first, second};
    const SplineCurve whole = joined(parts);
    EXPECT_EQ(whole.knots.size(), whole.points.size() + 4);
    EXPECT_EQ(std::count(whole.knots.begin(), whole.knots.end(), 2.0), 3);
    for (double t = 0; t <= 5; t += 0.125)
        EXPECT_LT((evaluate(whole, t) - (t < 2 ? evaluate(first, t) : evaluate(second, t - 2))).norm(),
                  1e-14);
}

TEST(SplineCurve, CommonKnotsKeepTheHigherMultiplicity) {
    const std::vector<double> a = {0, 0, 1, 2, 2, 2, 3};
    const std::vector<double> b = {0, 1, 1, 2, 2.5, 3, 3};
    EXPECT_EQ(commonKnots(a, b), (std::vector<double>{0, 0, 1, 1, 2, 2, 2, 2.5, 3, 3}));
}

} // namespace
} // namespace qm
