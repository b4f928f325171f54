#include "bspline/reference/scan/triangle_surface.h"
#include "shape/scan.h"
#include "shape/shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace qm {
namespace {

using Nearest = TriangleSurface::Nearest;

/// Two triangles that make a unit square.
Triangles square() {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

Triangles soup(std::mt19937& random, int triangles) {
    std::uniform_real_distribution<double> place(0, 1);
    Triangles result;
    for (int k = 0; k < triangles; ++k) {
        const Point corner(place(random), place(random), place(random));
        for (int n = 0; n < 3; ++n)
            result.points.push_back(corner + 0.2 * Point(place(random), place(random), place(random)));
        result.faces.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    return result;
}

/// The distance to the nearest of many points on each triangle.
double coarseDistance(const Triangles& triangles, const Point& point) {
    constexpr int parts = 60;
    double best = 1e9;
    for (const auto& [a, b, c] : triangles.faces)
        for (int i = 0; i <= parts; ++i)
            for (int j = 0; i + j <= parts; ++j) {
                const auto at = [&](int k) { return triangles.points[static_cast<std::size_t>(k)]; };
                const Point on = (at(a) * (parts - i - j) + at(b) * i + at(c) * j) / parts;
                best = std::min(best, (on - point).norm());
            }
    return best;
}

TEST(TriangleSurface, FindsTheNearestPointOfAnyTriangles) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-0.5, 1.5);
    const Triangles triangles = soup(random, 30);
    const TriangleSurface surface(triangles);
    for (int k = 0; k < 40; ++k) {
        const Point point(place(random), place(random), place(random));
        const Nearest nearest = surface.nearest(point).value();
        const double coarse = coarseDistance(triangles, point);
        EXPECT_LE(nearest.distance, coarse + 1e-12);
        EXPECT_GE(nearest.distance, coarse - 0.01);
        EXPECT_NEAR((nearest.position - point).norm(), nearest.distance, 1e-12);
        EXPECT_TRUE(surface.nearest(point, nearest.distance * 1.001).has_value());
        EXPECT_FALSE(surface.nearest(point, nearest.distance * 0.999).has_value());
    }
}

TEST(TriangleSurface, SaysWhereItEnds) {
    const TriangleSurface surface(square());
    EXPECT_TRUE(surface.nearest({0.5, -1, 0})->onBoundary);
    EXPECT_TRUE(surface.nearest({2, 2, 1})->onBoundary);
    EXPECT_TRUE(surface.nearest({1, 0, 1})->onBoundary) << "above a corner";
    EXPECT_FALSE(surface.nearest({0.5, 0.5, 1})->onBoundary) << "on the diagonal";
    EXPECT_FALSE(surface.nearest({0.3, 0.2, -1})->onBoundary);
    const TriangleSurface closed(makeScan("cube", 500));
    EXPECT_FALSE(closed.nearest({2, 2, 2})->onBoundary);
    EXPECT_FALSE(closed.nearest({0.5, 0.5, 0.9})->onBoundary);
}

TEST(TriangleSurface, HasTheNormalsOfASphere) {
    const TriangleSurface sphere(makeScan("sphere", 20000));
    std::mt19937 random(2);
    std::normal_distribution<double> coordinate;
    for (int k = 0; k < 200; ++k) {
        Point direction(coordinate(random), coordinate(random), coordinate(random));
        direction.normalize();
        const Nearest nearest = sphere.nearest(1.3 * direction).value();
        EXPECT_GT(nearest.normal.value() | direction, 0.9999);
        EXPECT_NEAR(nearest.distance, 0.3, 1e-3);
    }
}

TEST(TriangleSurface, ALineMeetsTheNearestFaceThatLooksTheRightWay) {
    const TriangleSurface cube(makeScan("cube", 500));
    const Point inside(0.4, 0.3, 0.9);
    EXPECT_NEAR(cube.alongLine(inside, {0, 0, 1}, 2)->position[2], 1, 1e-12);
    EXPECT_NEAR(cube.alongLine(inside, {0, 0, 1}, 2, 0.5)->position[2], 1, 1e-12);
    EXPECT_NEAR(cube.alongLine(inside, {0, 0, -1}, 2, 0.5)->position[2], 0, 1e-12);
    EXPECT_FALSE(cube.alongLine(inside, {0, 0, -1}, 0.8, 0.5).has_value()) << "that face is 0.9 away";
    EXPECT_FALSE(cube.alongLine({2, 2, 2}, {0, 0, 1}, 9).has_value());
    EXPECT_FALSE(TriangleSurface(square()).alongLine({-1, 0.2, 0}, {1, 0, 0}, 9).has_value())
        << "seen edge on";
}

TEST(TriangleSurface, DistanceFromATriangleIsThatFromItsNearestPoint) {
    const TriangleSurface triangle({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}});
    EXPECT_NEAR(triangle.distance(0, {0.5, 0.5, -3}), 3, 1e-12);
    EXPECT_NEAR(triangle.distance(0, {2, 2, 0}), std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(triangle.distance(0, {-3, -4, 0}), 5, 1e-12);
    EXPECT_NEAR(TriangleSurface({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 1, 2}}}).distance(0, {2, 1, 0}), 1,
                1e-12);
}

TEST(TriangleSurface, FlatAndFarTrianglesDoNoHarm) {
    const TriangleSurface line({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 1, 2}}});
    EXPECT_NEAR(line.nearest({2, 1, 0})->distance, 1, 1e-12);
    EXPECT_FALSE(line.nearest({2, 1, 0})->normal.has_value());
    const TriangleSurface far({{{1e150, 0, 0}, {0, 1e150, 0}, {0, 0, 1e150}}, {{0, 1, 2}}});
    EXPECT_TRUE(far.nearest({0, 0, 0}).has_value());
    (void)far.alongLine({0, 0, 0}, {0, 0, 1}, 1e150);
}

} // namespace
} // namespace qm
