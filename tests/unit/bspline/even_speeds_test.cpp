#include "base/at.h"
#include "bspline/reference/lattice/lagrange.h"
#include "bspline/reference/limit/even_speeds.h"
#include "bspline/splines/evaluate.h"
#include "support/grid_layout.h"
#include "support/limit_sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace qm {
namespace {

using test::LimitSample;
using test::noCreases;
using test::shape;
using test::stirred;

TEST(EvenSpeeds, AreThoseOfArcsBetweenTheVertices) {
    const LimitSample sample(stirred(shape("torus", 4), 0.04, [](const Point& point) { return point; }));
    MeshLattice even = sample.limit;
    evenSpeeds(even, sample.sharpness(), sample.noPlanes(), 1);
    const auto unevenness = [&](const MeshLattice& lattice) {
        double sum = 0;
        for (const HalfedgeId side : sample.mesh.halfedges()) {
            const auto distance = [&](int from, int to) {
                return (lattice.point(side, from, 0) - lattice.point(side, to, 0)).norm();
            };
            sum += std::abs(std::log(distance(0, 1) / distance(3, 4)));
        }
        return sum;
    };
    EXPECT_LT(unevenness(even), 0.5 * unevenness(sample.limit));
    for (const VertexId vertex : sample.mesh.vertices())
        EXPECT_EQ(even.point(at(vertex)), sample.limit.point(at(vertex)));
}

TEST(EvenSpeeds, LeaveEvenLinesAsTheyAre) {
    const LimitSample sample(shape("tube", 4));
    MeshLattice even = sample.limit;
    evenSpeeds(even, sample.sharpness(), sample.noPlanes(), 1);
    for (std::size_t k = 0; k < even.numbers().count(); ++k)
        EXPECT_LT((even.point(k) - sample.limit.point(k)).norm(), 1e-3);
}

TEST(EvenSpeeds, AreThoseOfTheirEdgesWhereQuadsAreBentToo) {
    // Corners go up and down in turn, so that no quad is flat within 20 degrees.
    const std::vector<double> columns{0, 1, 2, 2.4, 2.8, 3.8, 4.8};
    const test::Grid grid{6, 4, [&](double i, double j) {
                              const bool isUp = static_cast<int>(i + j) % 2 == 0;
                              return Point(columns[static_cast<std::size_t>(i)], j, isUp ? 0.2 : 0);
                          }};
    const LimitSample sample(test::makeMesh(grid));
    MeshLattice even = sample.limit;
    evenSpeeds(even, sample.sharpness(), sample.noPlanes(), 1);
    const auto maxSpeed = [&](const MeshLattice& lattice) {
        double max = 0;
        for (const HalfedgeId side : sample.mesh.halfedges())
            max = std::max(max, lattice.derivative(side).norm() / sample.mesh.calc_edge_length(side));
        return max;
    };
    EXPECT_GT(maxSpeed(sample.limit), 1.6);
    EXPECT_LT(maxSpeed(even), 1.3);
}

/// A cylinder whose vertices are turned about its axis by different angles, at its ends too.
QuadMesh unevenTube() {
    QuadMesh mesh = shape("tube", 4);
    for (const VertexId vertex : mesh.vertices()) {
        const Point point = mesh.point(vertex);
        const double angle = 0.08 * std::sin(17.0 * static_cast<double>(at(vertex)));
        mesh.set_point(vertex, Point(std::cos(angle) * point[0] - std::sin(angle) * point[1],
                                     std::sin(angle) * point[0] + std::cos(angle) * point[1], point[2]));
    }
    return mesh;
}

TEST(EvenSpeeds, BoundariesFollowTheirCurveWhereTheirEdgesAreUneven) {
    const LimitSample sample(unevenTube());
    MeshLattice even = sample.limit;
    evenSpeeds(even, sample.sharpness(), sample.noPlanes(), 1);
    // Along a circle derivatives are perpendicular to the radius.
    const auto maxRise = [&](const MeshLattice& lattice) {
        double max = 0;
        for (const HalfedgeId side : sample.mesh.halfedges()) {
            if (!sample.mesh.is_boundary(sample.mesh.edge_handle(side))) continue;
            Point radius = sample.mesh.point(sample.mesh.from_vertex_handle(side));
            radius[2] = 0;
            max = std::max(max, std::abs(unit(lattice.derivative(side)) | unit(radius)));
        }
        return max;
    };
    EXPECT_GT(maxRise(sample.limit), 0.01);
    EXPECT_LT(maxRise(even), 0.5 * maxRise(sample.limit));
}

TEST(EvenSpeeds, TurnsVaryEvenlyFromLineToLine) {
    // Parabolas along j that are flat at the boundary j = 0, and bend more and more along i.
    const test::Grid grid{8, 5, [](double i, double j) { return Point(i, j, 0.02 * i * j * j); }};
    const LimitSample sample(test::makeMesh(grid));
    MeshLattice even = sample.limit;
    evenSpeeds(even, sample.sharpness(), sample.noPlanes(), 1);
    // The slope at the boundary, along a row of the face between columns 3 and 4.
    const HalfedgeId side = sample.mesh.find_halfedge(VertexId(3), VertexId(4));
    ASSERT_FALSE(sample.mesh.is_boundary(side));
    const auto slope = [&](const MeshLattice& lattice, int along) {
        return derivativeAtEnd(lattice.squares(), 0, [&](int k) { return lattice.point(side, along, k); })[2];
    };
    EXPECT_GT(slope(sample.limit, 2), 0.02);
    EXPECT_LT(std::abs(slope(even, 2)), 0.002);
    const double quarter = 0.75 * slope(even, 0) + 0.25 * slope(even, 4);
    EXPECT_NEAR(slope(even, 1), quarter, 1e-4) << "no steps at the lines";
}

TEST(EvenSpeeds, LeaveTheSurfaceSmoothWhereACreaseEnds) {
    // A crease along j = 3 that ends at i = 4, with a plane on one side and something round on the other.
    const test::Grid grid{
        8, 6, [](double i, double j) { return Point(i, j, 0.05 * std::pow(std::max(0.0, j - 3), 2)); }};
    const QuadMesh mesh = test::makeMesh(grid);
    const auto vertex = [](int i, int j) { return VertexId(9 * j + i); };
    std::vector<bool> creases = noCreases(mesh);
    for (int i = 0; i < 4; ++i)
        creases[at(mesh.edge_handle(mesh.find_halfedge(vertex(i, 3), vertex(i + 1, 3))))] = true;
    const LimitSample sample(mesh, creases);
    ASSERT_EQ(sample.rules[at(vertex(4, 3))].kind, VertexRule::Kind::dart);
    MeshLattice even = sample.limit;
    evenSpeeds(even, sample.sharpness(), sample.noPlanes(), 1);
    // Derivatives across the first smooth edge, on both sides.
    const HalfedgeId side = sample.mesh.find_halfedge(vertex(4, 3), vertex(5, 3));
    const HalfedgeId other = sample.mesh.opposite_halfedge_handle(side);
    const auto across = [&](HalfedgeId from, int along) {
        return derivativeAtEnd(even.squares(), 0, [&](int k) { return even.point(from, along, k); });
    };
    for (int along = 1; along < 4; ++along)
        EXPECT_LT((unit(across(side, along)) + unit(across(other, 4 - along))).norm(), 1e-3) << along;
}

TEST(EvenSpeeds, AreTheSameOnAnyNumberOfThreads) {
    const LimitSample sample(shape("genus2", 6));
    MeshLattice one = sample.limit;
    MeshLattice three = sample.limit;
    evenSpeeds(one, sample.sharpness(), sample.noPlanes(), 1);
    evenSpeeds(three, sample.sharpness(), sample.noPlanes(), 3);
    for (std::size_t k = 0; k < one.numbers().count(); ++k)
        ASSERT_EQ(one.point(k), three.point(k));
}

} // namespace
} // namespace qm
