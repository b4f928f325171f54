#include "check/surfaces/folds.h"
#include "support/polycube.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace qm::test {
namespace {

using namespace check;

const BilinearQuad unitSquare{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}};

TEST(BilinearQuad, IsTheSquareBetweenItsCorners) {
    EXPECT_EQ(unitSquare.at(0.25, 0.5), (Place{0.25, 0.5, 0}));
    EXPECT_EQ(unitSquare.normal(), (Vector{0, 0, 2}));
    EXPECT_TRUE(unitSquare.isConvex());
    const BilinearQuad saddle{{{{0, 0, 0}, {1, 0, 0}, {1, 1, -4}, {0, 1, 0}}}};
    EXPECT_EQ(saddle.at(0.5, 0.5), (Place{0.5, 0.5, -1}));
    EXPECT_EQ(largestCoordinate(saddle.corners), 4);
}

TEST(BilinearQuad, IsNotConvexWithAReflexCorner) {
    EXPECT_FALSE((BilinearQuad{{{{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}}}}.isConvex()));
}

/// Samples above a quad of a surface whose normals are given.
bool folds(const std::function<Vector(double, double)>& normalAt, const BilinearQuad& quad = unitSquare) {
    std::vector<SurfacePoint> points;
    // Samples of the quads before and behind the tested one do not count.
    constexpr int width = 3 * samplesPerEdge + 1;
    for (int j = 0; j <= samplesPerEdge; ++j)
        for (int i = 0; i < width; ++i) {
            const double s = static_cast<double>(i) / samplesPerEdge - 1;
            const double t = static_cast<double>(j) / samplesPerEdge;
            const Vector normal = s < 0 || s > 1 ? Vector{0, 0, -1} : normalAt(s, t);
            // Two tangents whose product is the normal, whose second component is zero.
            SurfacePoint point;
            point.alongU = {normal[2], 0, -normal[0]};
            point.alongV = {0, 1, 0};
            points.push_back(point);
        }
    return isFolded(quad, {points, width, samplesPerEdge});
}

Vector leaning(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::sin(angle), 0, std::cos(angle)};
}

TEST(CheckFolds, LetASurfaceLean) {
    EXPECT_FALSE(folds([](double, double) { return leaning(0); }));
    EXPECT_FALSE(folds([](double, double) { return leaning(145); }));
    EXPECT_TRUE(folds([](double, double) { return leaning(155); }));
}

TEST(CheckFolds, SeeANormalThatTurnsOver) {
    const auto turningBy = [](double degrees) {
        return folds([&](double s, double) { return leaning(s > 0.7 ? degrees : 0); });
    };
    EXPECT_FALSE(turningBy(115));
    EXPECT_TRUE(turningBy(125));
    EXPECT_TRUE(folds([](double, double t) { return leaning(t > 0.7 ? 125 : 0); }));
}

TEST(CheckFolds, LeaveTheCornersOut) {
    const auto isAt = [](double x, double y, double s, double t) {
        return std::hypot(s - x, t - y) < 0.5 / samplesPerEdge;
    };
    EXPECT_FALSE(folds([&](double s, double t) { return leaning(isAt(1, 1, s, t) ? 180 : 0); }));
    EXPECT_TRUE(folds([&](double s, double t) { return leaning(isAt(1, 0.75, s, t) ? 180 : 0); }));
}

TEST(CheckFolds, AskNothingOfAQuadThatIsAlmostATriangle) {
    const auto turningOver = [](double s, double) { return leaning(s > 0.7 ? 180 : 0); };
    const auto withCornerAt = [](double x) {
        return BilinearQuad{{{{0, 0, 0}, {1, 0, 0}, {x, x, 0}, {0, 1, 0}}}};
    };
    EXPECT_TRUE(folds(turningOver, withCornerAt(0.6))) << "157 degrees";
    EXPECT_FALSE(folds(turningOver, withCornerAt(0.55))) << "169 degrees";
}

TEST(CheckFolds, AskNothingOfAQuadThatLiesAgainstAnother) {
    CheckedMesh mesh = plane({"xx"});
    const auto lies = [&](double degrees) {
        // Turns the second square about the edge that it shares with the first.
        for (Place& point : mesh.points)
            if (point[0] != 1 && point[0] != 0)
                point = {1 + leaning(degrees)[2], point[1], leaning(degrees)[0]};
        const Neighbourhoods around(mesh);
        return liesAgainstNeighbour(mesh, around, dihedralAngles(mesh, around), 0);
    };
    EXPECT_FALSE(lies(95));
    EXPECT_TRUE(lies(105));
}

} // namespace
} // namespace qm::test
