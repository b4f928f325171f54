#include "base/at.h"
#include "mesh/files/write_soup.h"
#include "mesh/quad_geometry.h"
#include "mesh/soup/build_mesh.h"
#include "mesh/topology.h"
#include "remesh/polygons/polygon_edges.h"
#include "remesh/polygons/subdivide_polygons.h"
#include "shape/shape.h"
#include "support/message_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace qm {
namespace {

constexpr double rho = 0.45;
constexpr double pi = std::numbers::pi;

using Faces = std::vector<std::vector<std::int64_t>>;

Soup soupOf(std::vector<Point> points, const Faces& faces) {
    Soup soup;
    soup.points = std::move(points);
    for (const auto& face : faces) {
        soup.corners.insert(soup.corners.end(), face.begin(), face.end());
        soup.endFace(0);
    }
    return soup;
}

/// A polygon in the plane z = 0.
Soup polygon(const std::vector<std::array<double, 2>>& corners) {
    std::vector<Point> points;
    std::vector<std::int64_t> face;
    for (const auto& [x, y] : corners) {
        face.push_back(static_cast<std::int64_t>(points.size()));
        points.emplace_back(x, y, 0);
    }
    return soupOf(points, {face});
}

/// Points on the unit circle.
std::vector<std::array<double, 2>> circle(int count) {
    std::vector<std::array<double, 2>> points;
    for (int k = 0; k < count; ++k)
        points.push_back({std::cos(2 * pi * k / count), std::sin(2 * pi * k / count)});
    return points;
}

/// A cylinder of height 1 with polygons at its ends.
Soup cylinder(int around) {
    std::vector<Point> points;
    Faces faces(2);
    for (const auto& [x, y] : circle(around)) {
        points.emplace_back(x, y, 0);
        points.emplace_back(x, y, 1);
    }
    for (std::int64_t k = 0; k < around; ++k) {
        const std::int64_t a = 2 * k, b = 2 * ((k + 1) % around);
        faces[0].insert(faces[0].begin(), a);
        faces[1].push_back(a + 1);
        faces.push_back({a, b, b + 1, a + 1});
    }
    return soupOf(points, faces);
}

QuadMesh meshOf(const Soup& polygons, double angle = rho) {
    return buildMesh(subdividePolygons(polygons, angle));
}

/// The smallest sine at a corner of any quad.
double minSine(const QuadMesh& mesh) {
    double least = 1;
    for (const FaceId face : mesh.faces())
        least = std::min(least, minCornerSine(mesh, face).value_or(-1));
    return least;
}

double areaOf(const QuadMesh& mesh) {
    double sum = 0;
    const Soup soup = qm::soupOf(mesh);
    for (std::size_t face = 0; face < soup.faceCount(); ++face)
        sum += areaVector(soup, face).norm() / 2;
    return sum;
}

TEST(Subdivision, KeepsVerticesAndMakesAQuadOfEveryCorner) {
    const Soup mixed =
        soupOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0.1}, {0, 1, 0}, {1, 1, 0.1}, {2, 1, 0}, {1, 2, 0}},
               {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 6}, {4, 5, 6}});
    const QuadMesh mesh = meshOf(mixed);
    EXPECT_EQ(mesh.n_faces(), 4U + 4 + 3 + 3);
    EXPECT_EQ(mesh.n_vertices(), 7U + 10 + 4);
    for (int k = 0; k < 7; ++k)
        EXPECT_EQ(mesh.point(VertexId(k)), mixed.points[at(k)]);
    EXPECT_EQ(cornersOf(mesh, FaceId(0))[0], VertexId(0));
}

TEST(Subdivision, PutsNewPointsOnTheSmoothSurfaceThroughTheVertices) {
    ShapeOptions options;
    options.around = 24;
    for (const char* name : {"sphere", "torus"}) {
        const QuadMesh coarse = makeShape(name, options);
        const Soup soup = qm::soupOf(coarse);
        // What is known of both: distances from the surface come from those of vertices and middles of edges.
        const auto distance = [&](const Point& p) {
            if (std::string(name) == "sphere") return std::abs(p.norm() - soup.points[0].norm());
            static const double major = [&] {
                double least = 1e9, largest = 0;
                for (const Point& q : soup.points) {
                    least = std::min(least, std::hypot(q[0], q[1]));
                    largest = std::max(largest, std::hypot(q[0], q[1]));
                }
                return (least + largest) / 2;
            }();
            const auto minor = [&](const Point& q) {
                return std::hypot(std::hypot(q[0], q[1]) - major, q[2]);
            };
            return std::abs(minor(p) - minor(soup.points[0]));
        };
        double straight = 0, smooth = 0;
        for (const EdgeId edge : coarse.edges())
            straight = std::max(straight, distance(coarse.calc_edge_midpoint(edge)));
        for (const Point& point : subdividePolygons(soup, rho).points)
            smooth = std::max(smooth, distance(point));
        EXPECT_LT(smooth, straight / 2) << name; // the points of faces are twice as far from straight lines
        EXPECT_GT(straight, 0) << name;
    }
}

TEST(Subdivision, KeepsSharpEdgesAndPlanes) {
    const QuadMesh cube = makeShape("cube", {});
    for (const Point& point : subdividePolygons(qm::soupOf(cube), rho).points) {
        int outer = 0;
        for (const double x : point)
            outer += std::abs(x - std::round(x)) < 1e-12 ? 1 : 0;
        EXPECT_GE(outer, 1);
    }
    const QuadMesh round = meshOf(cylinder(16));
    double farthest = 0;
    for (const VertexId vertex : round.vertices()) {
        const Point& p = round.point(vertex);
        const double radius = std::hypot(p[0], p[1]);
        EXPECT_TRUE(std::abs(p[2]) < 1e-12 || std::abs(p[2] - 1) < 1e-12 || radius > 0.99);
        farthest = std::max(farthest, std::abs(radius - 1) * (radius > 0.99 ? 1 : 0));
    }
    EXPECT_LT(farthest, (1 - std::cos(pi / 16)) / 10); // the sag of straight sides
}

TEST(Subdivision, SmoothsEdgesBelowTheAngle) {
    const QuadMesh round = meshOf(cylinder(6), rho); // 60 degrees at every side
    for (const VertexId vertex : round.vertices())
        EXPECT_LE(round.point(vertex).norm(), std::sqrt(2) + 1e-12);
    const auto largest = [](const QuadMesh& mesh) {
        double radius = 0;
        for (const VertexId vertex : mesh.vertices())
            radius = std::max(radius, std::hypot(mesh.point(vertex)[0], mesh.point(vertex)[1]));
        return radius;
    };
    EXPECT_NEAR(largest(round), 1, 1e-12);
    double middle = 0;
    const QuadMesh smooth = meshOf(cylinder(6), 1.2);
    for (const VertexId vertex : smooth.vertices())
        if (const Point& p = smooth.point(vertex); std::abs(p[2] - 0.5) < 1e-9)
            middle = std::max(middle, std::abs(std::hypot(p[0], p[1]) - std::cos(pi / 6)));
    EXPECT_GT(middle, 0.01);
}

TEST(Subdivision, FillsTheEndsOfCylindersByGrids) {
    for (const int around : {12, 13, 24, 31}) {
        const QuadMesh mesh = meshOf(cylinder(around));
        EXPECT_EQ(extraordinaryVertices(mesh).size(), 8U) << around; // four in each end
        EXPECT_GT(minSine(mesh), 0.15) << around;
    }
    // Eight corners of 135 degrees are enough of a corner each.
    EXPECT_EQ(extraordinaryVertices(meshOf(cylinder(8))).size(), 2U + 16);
}

TEST(Subdivision, DividesPolygonsThatReachAroundTheirMiddle) {
    const QuadMesh angle = meshOf(polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}));
    EXPECT_GT(minSine(angle), 0.3);
    EXPECT_NEAR(areaOf(angle), 5, 1e-12);
    // A corner in the middle of a side, where a finer neighbour begins.
    const QuadMesh hanging = meshOf(polygon({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}));
    EXPECT_GT(minSine(hanging), 0.3);
    EXPECT_NEAR(areaOf(hanging), 2, 1e-12);
}

TEST(Subdivision, OfRandomPolygonsCoversThemWithoutFolds) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 300; ++trial) {
        const int count = 3 + trial % 40;
        std::uniform_real_distribution<double> radius(0.3, 1);
        std::vector<std::array<double, 2>> corners = circle(count);
        for (auto& [x, y] : corners) {
            const double factor = radius(random);
            x *= factor;
            y *= factor;
        }
        const Soup star = polygon(corners);
        const QuadMesh mesh = meshOf(star);
        EXPECT_NEAR(areaOf(mesh), areaVector(star, 0).norm() / 2, 0.2); // the outline is smooth
        for (const FaceId face : mesh.faces())
            EXPECT_GT(middleNormal(mesh, face).value_or(Point(0, 0, 0))[2], 0.999) << count;
        EXPECT_GT(minSine(mesh), -1e-9) << count;
    }
}

TEST(Subdivision, AddsNoSideTwice) {
    // Two equal polygons back to back.
    Soup pillow = polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}});
    for (const std::int64_t corner : {5, 4, 3, 2, 1, 0})
        pillow.corners.push_back(corner);
    pillow.endFace(0);
    const QuadMesh mesh = meshOf(pillow);
    for (const EdgeId edge : mesh.edges())
        EXPECT_FALSE(mesh.is_boundary(edge));
}

TEST(Subdivision, LeavesOutWhatIsNoFace) {
    const Soup soup =
        soupOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 2}, {0, 0, 2, 3}, {1, 1, 2, 2}});
    EXPECT_EQ(meshOf(soup).n_faces(), 6U);
    const Soup nothing = soupOf({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1, 0}});
    EXPECT_EQ(test::messageOf([&] { (void)subdividePolygons(nothing, rho); }),
              "none of its faces has three different corners. Use another copy of the file");
}

TEST(Subdivision, SurvivesPolygonsThatCrossThemselvesOrHaveNoArea) {
    for (const Soup& soup :
         {polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), polygon({{0, 0}, {1, 0}, {2, 0}, {3, 0}}),
          polygon({{0, 0}, {0, 0}, {0, 0}}), polygon({{0, 0}, {2, 2}, {0, 2}, {2, 0}, {1, 3}})})
        for (const Point& point : subdividePolygons(soup, rho).points)
            EXPECT_TRUE(std::isfinite(point.norm()));
}

TEST(Subdivision, LeavesCombsOfVeryManyCornersWhole) {
    // A comb of more corners than are divided.
    std::vector<std::array<double, 2>> comb;
    for (int k = 0; k < 1200; ++k)
        comb.push_back({static_cast<double>(k), k % 2 == 0 ? 0.0 : 10.0});
    comb.push_back({1200, 20});
    comb.push_back({0, 20});
    EXPECT_EQ(subdividePolygons(polygon(comb), rho).faceCount(), comb.size());
}

} // namespace
} // namespace qm
