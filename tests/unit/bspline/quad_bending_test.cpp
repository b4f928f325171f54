#include "bspline/reference/bending/quad_bending.h"
#include "bspline/reference/lattice/lagrange.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

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

/// Quads around an extraordinary vertex in a plane, all of which have that vertex at the same corner.
class TiltedStar {
public:
    TiltedStar(int valence, std::size_t corner, double twist)
        : valence_(valence), ends_(quadCorners[corner]) {
        TangentFrame frame = upright();
        frame.dual.fill(Eigen::Vector3d::Zero());
        frame.twistOfSlopes = twist;
        CornerFrames frames{};
        frames[corner] = &frame;
        CornerTilts tilts = CornerTilts::Zero();
        tilts.segment<2>(static_cast<Eigen::Index>(3 * corner)) << 0.1, 0.07;
        for (int k = 0; k < valence; ++k) {
            std::vector<Eigen::Vector3d> points = flat(k);
            const auto lifts = QuadSurface(steps, points).displacements(frames, tilts);
            for (std::size_t n = 0; n < points.size(); ++n)
                points[n] += lifts[n];
            quads_.emplace_back(steps, points);
        }
    }

    /// The largest difference of normals across edges that leave the vertex, a little way from it.
    [[nodiscard]] double jump() const {
        double max = 0;
        for (int k = 0; k < valence_; ++k)
            max =
                std::max(max, (normal(k, first_) - normal((k + valence_ - 1) % valence_, 1 - first_)).norm());
        return max;
    }

private:
    [[nodiscard]] double parameter(std::size_t direction, double way) const {
        return ends_[direction] == 0 ? way : 1 - way;
    }

    [[nodiscard]] std::vector<Eigen::Vector3d> flat(int k) const {
        const auto edge = [&](std::size_t direction) {
            const int number = direction == first_ ? k : k + 1;
            const double angle = 2 * std::numbers::pi * number / valence_;
            return Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
        };
        std::vector<Eigen::Vector3d> points;
        for (int j = 0; j <= steps; ++j)
            for (int i = 0; i <= steps; ++i)
                points.emplace_back(parameter(0, static_cast<double>(i) / steps) * edge(0) +
                                    parameter(1, static_cast<double>(j) / steps) * edge(1));
        return points;
    }

    /// Of a quad, on the edge in a direction.
    [[nodiscard]] Eigen::Vector3d normal(int k, std::size_t direction) const {
        std::array<double, 2> at{parameter(0, 0), parameter(1, 0)};
        at[direction] = parameter(direction, 1.0 / 64);
        const auto derivatives =
            quads_[static_cast<std::size_t>(k)].secondOrder(lagrange(steps, at[0]), lagrange(steps, at[1]));
        return derivatives.u.cross(derivatives.v).normalized();
    }

    int valence_;
    std::array<std::size_t, 2> ends_;
    /// The direction of the first of both edges in a quad, counter-clockwise.
    std::size_t first_ = ends_[0] == ends_[1] ? 0 : 1;
    std::vector<QuadSurface> quads_;
};

TEST(QuadBending, KeepsTiltedQuadsAroundAVertexTangent) {
    for (const int valence : {3, 5, 6, 9})
        for (std::size_t corner = 0; corner < 4; ++corner)
            EXPECT_LT(TiltedStar(valence, corner, twistOfSlopes(valence)).jump(),
                      0.1 * TiltedStar(valence, corner, 0).jump());
    EXPECT_EQ(twistOfSlopes(4), 0);
    EXPECT_EQ(twistOfSlopes(2), 0);
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
