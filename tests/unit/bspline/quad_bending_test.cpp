#include "bspline/reference/bending/quad_bending.h"
#include "bspline/reference/lattice/lagrange.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace qm {
namespace {

using Surface = std::function<Eigen::Vector3d(double, double)>;

constexpr int steps = 4;

QuadSurface sampled(const Surface& surface) {
    std::vector<Eigen::Vector3d> points;
    for (int j = 0; j <= steps; ++j)
        for (int i = 0; i <= steps; ++i)
            points.push_back(surface(static_cast<double>(i) / steps, static_cast<double>(j) / steps));
    return {steps, points};
}

/// With mesh lines along its axes.
TangentFrame frameAround(const Eigen::Vector3d& normal) {
    const Eigen::Vector3d along = normal.unitOrthogonal();
    const std::array<Eigen::Vector3d, 2> axes{along, normal.cross(along)};
    return {normal, axes, axes};
}

TangentFrame upright() {
    return frameAround({0, 0, 1});
}

TEST(Lagrange, IsExactForPolynomialsOfItsDegree) {
    for (const double t : {0.0, 0.3, 1.0}) {
        const auto weights = lagrange(steps, t);
        Jet sum{};
        for (std::size_t k = 0; k <= steps; ++k)
            for (std::size_t order = 0; order < 3; ++order)
                sum[order] += weights[k][order] * std::pow(static_cast<double>(k) / steps, 4);
        EXPECT_NEAR(sum[0], std::pow(t, 4), 1e-13);
        EXPECT_NEAR(sum[1], 4 * std::pow(t, 3), 1e-12);
        EXPECT_NEAR(sum[2], 12 * t * t, 1e-11);
        EXPECT_EQ(weights[steps + 1], Jet{});
    }
}

TEST(QuadBending, OfAPlaneAsksForNoTilts) {
    // The parameter lines of this plane turn and crowd, which is no bending.
    const QuadSurface plane = sampled([](double u, double v) {
        return Eigen::Vector3d(u + 0.3 * u * v + 0.2 * v * v, v - 0.2 * u * u, 0.1 * v - 0.02 * u * u);
    });
    const TangentFrame frame = frameAround(plane.normal(0));
    const QuadBending bending = quadBending(plane, {&frame, &frame, &frame, &frame});
    EXPECT_LT(bending.right.norm(), 1e-12);
    EXPECT_LT((bending.matrix - bending.matrix.transpose()).norm(), 1e-12);
    // All eigenvalues are above 1e-3.
    const Eigen::MatrixXd above = bending.matrix - 1e-3 * Eigen::MatrixXd::Identity(12, 12);
    EXPECT_EQ(above.llt().info(), Eigen::Success);
}

TEST(QuadBending, IsMinimalWhereTiltsTakeAwayWhatTiltsGave) {
    const TangentFrame frame = upright();
    const CornerFrames frames{&frame, &frame, &frame, nullptr};
    // The parameter lines of this surface turn and crowd; only its distance from the plane may count.
    const Surface flat = [](double u, double v) {
        return Eigen::Vector3d(2 * u + 0.2 * v + 0.3 * u * u + 0.1 * u * v, v - 0.2 * u * v, 0);
    };
    CornerTilts tilts;
    tilts << 0.01, -0.02, 0.01, 0.015, 0.01, -0.02, -0.005, 0.02, 0.015, 0, 0, 0;
    const auto ways = sampled(flat).displacements(frames, tilts);
    std::size_t next = 0;
    std::vector<Eigen::Vector3d> points;
    for (int j = 0; j <= steps; ++j)
        for (int i = 0; i <= steps; ++i)
            points.emplace_back(flat(static_cast<double>(i) / steps, static_cast<double>(j) / steps) +
                                ways[next++]);
    for (const std::size_t corner : {0U, 4U, 20U, 24U})
        EXPECT_LT(ways[corner].norm(), 1e-15);
    const QuadBending bending = quadBending(QuadSurface(steps, points), frames);
    EXPECT_EQ(bending.matrix.rightCols(3).norm(), 0); // of the corner that is fixed
    EXPECT_EQ(bending.right.tail(3).norm(), 0);
    const Eigen::MatrixXd matrix = bending.matrix.topLeftCorner(9, 9);
    const Eigen::VectorXd undone = matrix.llt().solve(Eigen::VectorXd(bending.right.head(9)));
    EXPECT_LT((undone + tilts.head(9)).norm(), 0.02 * tilts.norm());
}

TEST(QuadBending, TakesSurfacesWithoutAnArea) {
    const TangentFrame frame = upright();
    const QuadBending bending = quadBending(
        sampled([](double u, double) { return Eigen::Vector3d(u, 0, 0); }), {&frame, &frame, &frame, &frame});
    EXPECT_EQ(bending.matrix.norm(), 0);
    EXPECT_EQ(bending.right.norm(), 0);
}

} // namespace
} // namespace qm
