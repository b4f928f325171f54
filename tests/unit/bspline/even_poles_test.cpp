#include "base/at.h"
#include "bspline/fit.h"
#include "bspline/reference/limit/even_poles.h"
#include "bspline/splines/evaluate.h"
#include "mesh/dihedral.h"
#include "mesh/topology.h"
#include "support/limit_sample.h"
#include "support/quad_layout.h"
#include "support/random_graph.h"
#include "support/star_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>

namespace qm {
namespace {

using test::LimitSample;

/// The height over a distance from the axis.
using Profile = std::function<double(double)>;

double paraboloid(double radius) {
    return -radius * radius / 2;
}

/// Triangles around one vertex, each divided into three quads, and a ring of quads around them.
QuadMesh dividedFan(int triangles, const Profile& profile) {
    const auto on = [&](double radius) { return test::FanRing{radius, profile(radius)}; };
    return test::dividedFan(triangles, profile(0), {on(0.3), on(0.35), on(0.55), on(0.8)});
}

/// Quads around one vertex, each with two of their sides on the boundary, on the unit sphere.
QuadMesh umbrella(int quads) {
    check::CheckedMesh mesh{{{0, 0, 1}}, {}};
    constexpr double slope = 1.2;
    for (int k = 0; k < 2 * quads; ++k) {
        const double angle = std::numbers::pi * k / quads;
        mesh.points.push_back(
            {std::sin(slope) * std::cos(angle), std::sin(slope) * std::sin(angle), std::cos(slope)});
    }
    for (int k = 0; k < quads; ++k)
        mesh.quads.push_back({0, 1 + 2 * k, 2 + 2 * k, 1 + (2 * k + 2) % (2 * quads)});
    return test::quadMesh(mesh);
}

MeshLattice evened(const LimitSample& sample) {
    MeshLattice lattice = sample.limit;
    evenPoles(lattice, sample.rules, 1);
    return lattice;
}

/// The largest slope with which a lattice leaves the vertex on the axis.
double steepest(const MeshLattice& lattice) {
    double largest = 0;
    const QuadMesh& mesh = lattice.numbers().mesh();
    for (const HalfedgeId leaving : mesh.voh_range(VertexId(0))) {
        const Point along = lattice.derivative(leaving);
        largest = std::max(largest, std::abs(along[2]) / std::hypot(along[0], along[1]));
    }
    return largest;
}

/// The largest distance from a profile of the points over quads around the vertex on the axis.
double farthest(const MeshLattice& lattice, const Profile& profile) {
    double largest = 0;
    const QuadMesh& mesh = lattice.numbers().mesh();
    for (const HalfedgeId leaving : mesh.voh_range(VertexId(0)))
        for (int j = 0; j <= lattice.squares(); ++j)
            for (int i = 0; i <= lattice.squares(); ++i) {
                const Point point = lattice.point(leaving, i, j);
                largest = std::max(largest, std::abs(point[2] - profile(std::hypot(point[0], point[1]))));
            }
    return largest;
}

TEST(EvenPoles, MakeAPlaneTangentOfATip) {
    for (const int triangles : {12, 25, 64}) {
        const LimitSample sample(dividedFan(triangles, paraboloid));
        const MeshLattice even = evened(sample);
        EXPECT_GT(steepest(sample.limit), 0.05) << triangles;
        EXPECT_LT(steepest(even), 1e-3) << triangles;
        if (triangles > 20) {
            EXPECT_LT(farthest(even, paraboloid), 0.7 * farthest(sample.limit, paraboloid)) << triangles;
        }
    }
}

TEST(EvenPoles, LeaveVerticesAndAllBeyondTheQuadsAround) {
    const LimitSample sample(dividedFan(16, paraboloid));
    const MeshLattice even = evened(sample);
    for (const VertexId vertex : sample.mesh.vertices())
        EXPECT_EQ(even.point(at(vertex)), sample.limit.point(at(vertex)));
    for (const FaceId face : sample.mesh.faces())
        if (std::ranges::none_of(sample.mesh.fv_range(face), [](VertexId v) { return v == VertexId(0); })) {
            EXPECT_EQ(even.points(face), sample.limit.points(face));
        }
}

TEST(EvenPoles, StayInTheirPlane) {
    const LimitSample sample(dividedFan(30, [](double) { return 2; }));
    const MeshLattice even = evened(sample);
    for (std::size_t k = 0; k < even.numbers().count(); ++k)
        EXPECT_NEAR(even.point(k)[2], 2, 1e-12);
}

TEST(EvenPoles, LeaveFewEdgesAndCreasesAsTheyAre) {
    LimitSample few(dividedFan(6, paraboloid));
    LimitSample creased(dividedFan(16, paraboloid));
    creased.rules[0] = {VertexRule::Kind::corner};
    for (const LimitSample& sample : {std::cref(few), std::cref(creased)}) {
        const MeshLattice even = evened(sample);
        for (std::size_t k = 0; k < even.numbers().count(); ++k)
            ASSERT_EQ(even.point(k), sample.limit.point(k));
    }
}

TEST(EvenPoles, LetSurfacesKeepTheTolerance) {
    for (const QuadMesh& mesh : {umbrella(25), dividedFan(70, paraboloid)}) {
        const Surfaces surfaces = fitSurfaces(mesh, test::segmentPerQuad(mesh), dihedralAngles(mesh), {});
        EXPECT_EQ(missedTolerance(surfaces, {}), "");
        EXPECT_TRUE(surfaces.folds.empty());
    }
}

} // namespace
} // namespace qm
