/// \file Moving control points into planes with the least change that equations allow.
#include "bspline/fitting/planes/min_change.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using qm::MinChange;
using qm::PlaneDemand;

/// The plane perpendicular to the third axis at a height.
qm::Plane level(double height) {
    return {{0, 0, 1}, height};
}

Eigen::MatrixX3d threePoints() {
    Eigen::MatrixX3d points(3, 3);
    points << 1, 0, 0.5, //
        2, 0, 0.25,      //
        3, 0, 0;
    return points;
}

/// The equation that keeps the middle one of three points in the middle.
std::vector<qm::LinearForm> straight() {
    return {{{0, 1, 2}, {1, -2, 1}}};
}

TEST(MinChange, MovesWhatIsDemandedAndWhatEquationsTakeAlong) {
    const MinChange change(3, straight());
    const std::vector<PlaneDemand> demands{{0, level(0)}};
    const Eigen::MatrixX3d before = threePoints();
    const Eigen::MatrixX3d after = change.run(demands, before);
    EXPECT_NEAR(after(0, 2), 0, 1e-14);
    EXPECT_LT(change.violation(after - before), 1e-14);
    // Of all changes a and b of the others with -0.5 - 2 a + b = 0, this one has the smallest sum of squares.
    EXPECT_NEAR(after(1, 2) - before(1, 2), -0.2, 1e-14);
    EXPECT_NEAR(after(2, 2) - before(2, 2), 0.1, 1e-14);
    EXPECT_EQ(after.leftCols(2), before.leftCols(2)) << "nothing moves along the plane";
}

TEST(MinChange, TakesNeighboursAlong) {
    // The first and the last point are moved by -1 and 2; those between are free.
    const MinChange change(5, {}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}});
    const Eigen::MatrixX3d before = Eigen::MatrixX3d::Zero(5, 3);
    const Eigen::MatrixX3d after = change.run({{0, level(-1)}, {4, level(2)}}, before);
    EXPECT_NEAR(after(0, 2), -1, 1e-14);
    EXPECT_NEAR(after(4, 2), 2, 1e-14);
    for (int k = 0; k < 4; ++k)
        EXPECT_GT(after(k + 1, 2), after(k, 2) + 0.2) << "they keep their order: " << k;
}

TEST(MinChange, LeavesWhatIsInItsPlaneAlready) {
    const MinChange change(3, straight());
    EXPECT_EQ(change.run({{2, level(0)}}, threePoints()), threePoints());
}

TEST(MinChange, TellsWhatCannotBeHad) {
    const MinChange change(2, {{{0, 1}, {1, -1}}});
    const std::vector<PlaneDemand> demands{{0, level(0)}, {1, level(1)}};
    const Eigen::MatrixX3d before = Eigen::MatrixX3d::Zero(2, 3);
    const Eigen::MatrixX3d after = change.run(demands, before);
    const double missing = qm::missingHeights(demands, after).cwiseAbs().maxCoeff();
    EXPECT_GT(std::max(missing, change.violation(after - before)), 0.49)
        << "either a plane is missed or the equation does not hold";
}

TEST(MinChange, MissesOnlyWhatContradicts) {
    // Two points that are tied to one another cannot be at two heights; the third is free.
    const MinChange change(3, {{{0, 1}, {1, -1}}});
    const qm::Plane slanted{qm::Point(0.6, 0, 0.8), 2};
    const std::vector<PlaneDemand> demands{{0, level(0)}, {1, level(1)}, {2, slanted}};
    const Eigen::MatrixX3d before = Eigen::MatrixX3d::Zero(3, 3);
    const Eigen::MatrixX3d after = change.run(demands, before);
    const Eigen::VectorXd missing = qm::missingHeights(demands, after);
    EXPECT_NEAR(missing[0], -0.5, 1e-9);
    EXPECT_NEAR(missing[1], 0.5, 1e-9);
    EXPECT_NEAR(missing[2], 0, 1e-14);
    EXPECT_LT(change.violation(after - before), 1e-14);
    EXPECT_NEAR((after.row(2) - Eigen::RowVector3d(1.2, 0, 1.6)).norm(), 0, 1e-14) << "the nearest point";
}

} // namespace
