#include "base/at.h"
#include "base/infinity.h"
#include "cut/surface_distances.h"
#include "mesh/soup/build_mesh.h"
#include "support/polycube.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace qm::test {
namespace {

double norm(const Point& point) {
    return point.norm();
}

/// A square of size x size quads with its vertices moved to `place`.
QuadMesh square(int size, const std::function<Point(double, double)>& place) {
    std::vector<Point> points;
    std::vector<std::array<int, 4>> quads;
    for (int j = 0; j <= size; ++j)
        for (int i = 0; i <= size; ++i) {
            points.push_back(place(i, j));
            const int corner = j * (size + 1) + i;
            if (i < size && j < size)
                quads.push_back({corner, corner + 1, corner + size + 2, corner + size + 1});
        }
    return buildMesh(points, quads);
}

/// A sphere of radius 1: the cube from -1 to 1, projected such that its grid lines are evenly spread.
QuadMesh sphere(int n) {
    check::CheckedMesh cube = polycube(box(1, 1, 1), n);
    for (auto& point : cube.points) {
        for (double& coordinate : point)
            coordinate = std::tan((2 * coordinate - 1) * std::numbers::pi / 4);
        const double length = std::hypot(point[0], point[1], point[2]);
        for (double& coordinate : point)
            coordinate /= length;
    }
    return quadMesh(cube);
}

struct Errors {
    double worst = 0;
    double mean = 0;
};

std::vector<VertexId> verticesOf(const QuadMesh& mesh, const std::vector<SubMeshId>& part, int label) {
    std::vector<VertexId> vertices;
    for (const VertexId vertex : mesh.vertices())
        if (part[at(vertex)] == SubMeshId(label)) vertices.push_back(vertex);
    return vertices;
}

/// Distances over all vertices of a part of a mesh.
class FineDistances {
public:
    FineDistances(const QuadMesh& mesh, const std::vector<SubMeshId>& part)
        : mesh_(mesh), part_(part), geodesics_(mesh, part) {}

    /// Of every vertex of the mesh; infinity outside the part.
    std::vector<double> from(VertexId source) {
        const std::vector<VertexId> vertices = verticesOf(mesh_, part_, part_[at(source)].value());
        geodesics_.prepare(vertices, 0);
        const std::vector<double> distances = geodesics_.between(source, vertices);
        std::vector<double> all(mesh_.n_vertices(), infinity);
        for (std::size_t k = 0; k < vertices.size(); ++k)
            all[at(vertices[k])] = distances[k];
        return all;
    }

private:
    const QuadMesh& mesh_;
    const std::vector<SubMeshId>& part_;
    SurfaceDistances geodesics_;
};

/// Relative errors of the distances from some vertices to all others.
Errors errors(const QuadMesh& mesh, const std::function<double(const Point&, const Point&)>& exact) {
    const std::vector<SubMeshId> whole(mesh.n_vertices(), SubMeshId(0));
    FineDistances geodesics(mesh, whole);
    Errors result;
    std::size_t count = 0;
    for (std::size_t source = 0; source < mesh.n_vertices(); source += 1 + mesh.n_vertices() / 5) {
        const VertexId from(static_cast<int>(source));
        const std::vector<double> distance = geodesics.from(from);
        for (const VertexId vertex : mesh.vertices()) {
            const double truth = exact(mesh.point(from), mesh.point(vertex));
            if (vertex == from || truth <= 0) continue;
            const double error = std::abs(distance[at(vertex)] / truth - 1);
            result.worst = std::max(result.worst, error);
            result.mean += error;
            ++count;
        }
    }
    result.mean /= static_cast<double>(count);
    return result;
}

double straight(const Point& a, const Point& b) {
    return norm(a - b);
}

double greatCircle(const Point& a, const Point& b) {
    return std::atan2(norm(a % b), a | b);
}

TEST(Geodesics, AreExactInThePlane) {
    EXPECT_LT(errors(square(20, [](double i, double j) { return Point(i, j, 0); }), straight).worst, 1e-9);
    EXPECT_LT(errors(square(20, [](double i, double j) { return Point(5 * i, j, 0); }), straight).worst,
              1e-9);
    EXPECT_LT(errors(square(20, [](double i, double j) { return Point(i + j, j, 0); }), straight).worst,
              1e-9);
}

TEST(Geodesics, AreExactOnWhatUnrollsIntoThePlane) {
    // A sheet folded along grid lines.
    const QuadMesh mesh =
        square(12, [](double i, double j) { return i <= 5 ? Point(i, j, 0) : Point(5, j, i - 5); });
    const auto unrolled = [](const Point& a, const Point& b) {
        return std::hypot(a[0] + a[2] - b[0] - b[2], a[1] - b[1]);
    };
    EXPECT_LT(errors(mesh, unrolled).worst, 1e-9);
}

TEST(Geodesics, GetBetterOnAFinerSphere) {
    const Errors coarse = errors(sphere(8), greatCircle), fine = errors(sphere(32), greatCircle);
    EXPECT_LT(coarse.mean, 0.02);
    EXPECT_LT(coarse.worst, 0.10);
    EXPECT_LT(fine.mean, 0.005);
    EXPECT_LT(fine.worst, 0.04);
}

TEST(Geodesics, StayInTheirPart) {
    const QuadMesh mesh = square(10, [](double i, double j) { return Point(i, j, 0); });
    // A wall in column 5 with a gap in the last row: vertices (0..4, j) reach (6..10, j) only around it.
    std::vector<SubMeshId> part(mesh.n_vertices(), SubMeshId(0));
    for (int j = 0; j < 10; ++j)
        part[at(j * 11 + 5)] = SubMeshId(1);
    FineDistances geodesics(mesh, part);
    const std::vector<double> distance = geodesics.from(VertexId(0));
    EXPECT_EQ(distance[5], infinity);
    EXPECT_DOUBLE_EQ(distance[4], 4);
    // From (0, 0) around (5, 10) to (10, 0); the path may cut the corner by a quad.
    EXPECT_NEAR(distance[10], 2 * std::hypot(5, 10), 0.5);
    EXPECT_GE(distance[10], 2 * std::hypot(4, 9));
}

TEST(Geodesics, ForgetWhatEarlierCallsFound) {
    const QuadMesh mesh = square(4, [](double i, double j) { return Point(i, j, 0); });
    std::vector<SubMeshId> part(mesh.n_vertices(), SubMeshId(0));
    FineDistances geodesics(mesh, part);
    EXPECT_DOUBLE_EQ(geodesics.from(VertexId(0))[24], std::hypot(4, 4));
    for (std::size_t k = 10; k < 25; ++k)
        part[k] = SubMeshId(1); // the upper rows from now on
    EXPECT_EQ(geodesics.from(VertexId(0))[24], infinity);
    EXPECT_DOUBLE_EQ(geodesics.from(VertexId(0))[9], std::hypot(4, 1));
    EXPECT_DOUBLE_EQ(geodesics.from(VertexId(24))[10], std::hypot(4, 2));
}

TEST(Geodesics, BeginAtSeveralVerticesAndWalkEdgesAndTriangles) {
    // An edge, a triangle and a square in a row, each repeating its last corner.
    const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0}};
    Geodesics geodesics(points, {{0, 1, 1, 1}, {1, 3, 2, 2}, {3, 4, 5, 2}});
    const std::vector<double>& distance = geodesics.from(std::array<Geodesics::Start, 1>{{{0, 0}}});
    EXPECT_DOUBLE_EQ(distance[1], 1);
    EXPECT_NEAR(distance[5], 1 + std::hypot(2, 1), 0.05);
    geodesics.from(std::array<Geodesics::Start, 2>{{{0, 0.5}, {5, 0.25}}});
    EXPECT_DOUBLE_EQ(distance[0], 0.5);
    EXPECT_DOUBLE_EQ(distance[1], 1.5);
    EXPECT_DOUBLE_EQ(distance[4], 1.25);
}

TEST(Geodesics, DoNotReachIsolatedVerticesAndOtherComponents) {
    const QuadMesh mesh = buildMesh(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}, {5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}},
        {{0, 1, 2, 3}, {5, 6, 7, 8}});
    const std::vector<SubMeshId> whole(9, SubMeshId(0));
    FineDistances geodesics(mesh, whole);
    const std::vector<double> fromQuad = geodesics.from(VertexId(0));
    EXPECT_DOUBLE_EQ(fromQuad[2], std::sqrt(2.0));
    EXPECT_EQ(fromQuad[4], infinity);
    EXPECT_EQ(fromQuad[6], infinity);
    const std::vector<double> fromIsolated = geodesics.from(VertexId(4));
    EXPECT_EQ(fromIsolated[4], 0);
    EXPECT_EQ(fromIsolated[0], infinity);
}

TEST(Geodesics, NeverBeatTheStraightWayNorLoseToTheEdges) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shake(-0.3, 0.3);
    for (int round = 0; round < 20; ++round) {
        const QuadMesh mesh = square(8, [&](double i, double j) {
            return Point(i + shake(random), j + shake(random), shake(random));
        });
        const std::vector<SubMeshId> whole(mesh.n_vertices(), SubMeshId(0));
        FineDistances geodesics(mesh, whole);
        const std::vector<double> distance = geodesics.from(VertexId(0));
        for (const VertexId vertex : mesh.vertices()) {
            // A quad that is not flat can be unfolded in two ways, and a front may use either.
            EXPECT_GE(distance[at(vertex)], 0.9 * norm(mesh.point(vertex) - mesh.point(VertexId(0))));
            for (const VertexId next : mesh.vv_range(vertex))
                EXPECT_LE(distance[at(next)],
                          distance[at(vertex)] + norm(mesh.point(vertex) - mesh.point(next)) + 1e-12);
        }
    }
}

TEST(Geodesics, AreNumbersOnMeshesWithoutSizeAndOfAnySize) {
    for (const double size : {0.0, 1e-300, 1e140}) {
        const QuadMesh mesh = square(4, [&](double i, double j) { return Point(size * i, size * j, 0); });
        const std::vector<SubMeshId> whole(mesh.n_vertices(), SubMeshId(0));
        FineDistances geodesics(mesh, whole);
        for (const double distance : geodesics.from(VertexId(12)))
            EXPECT_FALSE(std::isnan(distance)) << size;
    }
}

/// Errors of coarse distances from some vertices to all others, as shares of the largest distance.
Errors coarseErrors(const QuadMesh& mesh, const std::function<double(const Point&, const Point&)>& exact) {
    const std::vector<SubMeshId> whole(mesh.n_vertices(), SubMeshId(0));
    const std::vector<VertexId> vertices = verticesOf(mesh, whole, 0);
    SurfaceDistances geodesics(mesh, whole);
    geodesics.prepare(vertices);
    Errors result;
    double longest = 0;
    std::size_t count = 0;
    for (std::size_t source = 0; source < mesh.n_vertices(); source += 1 + mesh.n_vertices() / 7) {
        const std::vector<double> distances = geodesics.between(vertices[source], vertices);
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            const double truth = exact(mesh.point(vertices[source]), mesh.point(vertices[k]));
            longest = std::max(longest, truth);
            result.worst = std::max(result.worst, std::abs(distances[k] - truth));
            result.mean += std::abs(distances[k] - truth);
            ++count;
        }
    }
    result.worst /= longest;
    result.mean /= static_cast<double>(count) * longest;
    return result;
}

TEST(CoarseDistances, AreNearTheTruthInThePlane) {
    const Errors even =
        coarseErrors(square(200, [](double i, double j) { return Point(i, j, 0); }), straight);
    EXPECT_LT(even.mean, 0.005);
    EXPECT_LT(even.worst, 0.02);
    const Errors sheared =
        coarseErrors(square(200, [](double i, double j) { return Point(i + j / 2, j, 0); }), straight);
    EXPECT_LT(sheared.mean, 0.01);
    EXPECT_LT(sheared.worst, 0.03);
}

TEST(CoarseDistances, AreNearTheTruthOnASphere) {
    const Errors errors = coarseErrors(sphere(60), greatCircle);
    EXPECT_LT(errors.mean, 0.01);
    EXPECT_LT(errors.worst, 0.03);
}

TEST(CoarseDistances, StayInTheirPartAndTurnToAnother) {
    const int size = 120;
    const QuadMesh mesh = square(size, [](double i, double j) { return Point(i, j, 0); });
    // A wall in the middle column with a gap in the last rows.
    std::vector<SubMeshId> part(mesh.n_vertices(), SubMeshId(0));
    for (int j = 0; j < size - 4; ++j)
        part[at(j * (size + 1) + size / 2)] = SubMeshId(1);
    SurfaceDistances geodesics(mesh, part);
    geodesics.prepare(verticesOf(mesh, part, 0), 1);
    const auto distance = [&](int from, int to) {
        return geodesics.between(VertexId(from), {VertexId(to)}).front();
    };
    const double aroundTheWall = 2 * std::hypot(size / 2, size - 4);
    EXPECT_NEAR(distance(0, size), aroundTheWall, 0.02 * aroundTheWall);
    EXPECT_EQ(distance(0, 0), 0);
    EXPECT_DOUBLE_EQ(distance(0, 1), 1);
    geodesics.prepare(verticesOf(mesh, part, 1), 1);
    const int last = (size - 5) * (size + 1) + size / 2;
    EXPECT_NEAR(distance(size / 2, last), size - 5, 1e-9);
}

TEST(CoarseDistances, DoNotReachOtherComponents) {
    std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                              {9, 0, 0}, {8, 0, 0}, {8, 1, 0}, {9, 1, 0}};
    const QuadMesh mesh = buildMesh(points, {{0, 1, 2, 3}, {7, 6, 5, 4}});
    const std::vector<SubMeshId> whole(mesh.n_vertices(), SubMeshId(0));
    SurfaceDistances geodesics(mesh, whole);
    geodesics.prepare(verticesOf(mesh, whole, 0), 1);
    const std::vector<double> distances = geodesics.between(VertexId(0), verticesOf(mesh, whole, 0));
    EXPECT_NEAR(distances[2], std::sqrt(2), 0.6);
    for (const std::size_t other : {4U, 5U, 6U, 7U})
        EXPECT_EQ(distances[other], infinity);
}

} // namespace
} // namespace qm::test
