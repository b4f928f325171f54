#include "base/at.h"
#include "bspline/reference/control_mesh.h"
#include "bspline/reference/even_speeds.h"
#include "bspline/reference/least_bending.h"
#include "shape/shape.h"
#include "support/quad_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace qm {
namespace {

using testing::segmentPerQuad;

struct Sample {
    QuadMesh mesh;
    std::vector<VertexRule> rules;
    MeshLattice limit;

    explicit Sample(QuadMesh given) : mesh(std::move(given)), limit(mesh, {}) {
        const auto sharp = creasesAndBoundary(mesh, std::vector<bool>(mesh.n_edges()));
        rules = vertexRules(mesh, segmentPerQuad(mesh), sharp);
        const ControlMesh control = interpolatingControlMesh(mesh, rules);
        MeshLattice lattice(mesh, control.points);
        for (int k = 0; k < 2; ++k)
            lattice = lattice.subdivided(rules, sharp, 1);
        limit = lattice.limit(rules, sharp, 1);
    }

    [[nodiscard]] MeshLattice bent(unsigned jobs = 1) const {
        MeshLattice lattice = limit;
        bendLeast(lattice, rules, jobs);
        return lattice;
    }
};

QuadMesh shape(const std::string& name, int resolution) {
    ShapeOptions options;
    options.resolution = resolution;
    return makeShape(name, options);
}

/// Moves every vertex along its sphere or plane, so that no line remains straight or evenly divided.
template <class Onto> QuadMesh stirred(QuadMesh mesh, double largest, const Onto& onto) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-largest, largest);
    for (const VertexId vertex : mesh.vertices()) {
        const Point by =
            mesh.is_boundary(vertex) ? Point(0, 0, 0) : Point(shift(random), shift(random), shift(random));
        mesh.set_point(vertex, onto(mesh.point(vertex) + by));
    }
    return mesh;
}

/// Root mean square distance from the unit sphere; single distances may be small by chance.
double fromSphere(const MeshLattice& lattice) {
    double sum = 0;
    for (std::size_t k = 0; k < lattice.numbers().count(); ++k)
        sum += std::pow(lattice.point(k).norm() - 1, 2);
    return std::sqrt(sum / static_cast<double>(lattice.numbers().count()));
}

TEST(LeastBending, BringsTheSurfaceNearerToASphere) {
    const auto onto = [](const Point& point) { return point / point.norm(); };
    for (const double by : {0.0, 0.02}) {
        const Sample sample(stirred(shape("sphere", 8), by, onto));
        EXPECT_LT(fromSphere(sample.bent()), 0.5 * fromSphere(sample.limit)) << by;
    }
}

TEST(LeastBending, TwistsQuadsOverSkewLines) {
    // A saddle is twisted along lines that run at half right angles to its bends.
    const auto onto = [](Point point) {
        point[2] = 0.5 * point[0] * point[1];
        return point;
    };
    const Sample sample(stirred(shape("plate", 4), 0.03, onto));
    const MeshLattice bent = sample.bent();
    const auto offSaddle = [&](const MeshLattice& lattice) {
        double sum = 0;
        for (const FaceId face : sample.mesh.faces()) {
            const bool isInside = std::ranges::none_of(
                sample.mesh.fv_range(face), [&](VertexId vertex) { return sample.mesh.is_boundary(vertex); });
            const Point middle = lattice.point(lattice.numbers()(sample.mesh.halfedge_handle(face), 2, 2));
            if (isInside) sum += std::pow(middle[2] - 0.5 * middle[0] * middle[1], 2);
        }
        return std::sqrt(sum);
    };
    EXPECT_LT(offSaddle(bent), 0.7 * offSaddle(sample.limit));
}

TEST(EvenSpeeds, AreThoseOfArcsBetweenTheVertices) {
    const Sample sample(stirred(shape("torus", 4), 0.04, [](const Point& point) { return point; }));
    MeshLattice even = sample.limit;
    evenSpeeds(even, 1);
    const auto unevenness = [&](const MeshLattice& lattice) {
        double sum = 0;
        for (const HalfedgeId side : sample.mesh.halfedges()) {
            const auto distance = [&](int from, int to) {
                return (lattice.point(lattice.numbers()(side, from, 0)) -
                        lattice.point(lattice.numbers()(side, to, 0)))
                    .norm();
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
    const Sample sample(shape("tube", 4));
    MeshLattice even = sample.limit;
    evenSpeeds(even, 1);
    for (std::size_t k = 0; k < even.numbers().count(); ++k)
        EXPECT_LT((even.point(k) - sample.limit.point(k)).norm(), 1e-3);
}

TEST(EvenSpeeds, AreTheSameOnAnyNumberOfThreads) {
    const Sample sample(shape("genus2", 6));
    MeshLattice one = sample.limit;
    MeshLattice three = sample.limit;
    evenSpeeds(one, 1);
    evenSpeeds(three, 3);
    for (std::size_t k = 0; k < one.numbers().count(); ++k)
        ASSERT_EQ(one.point(k), three.point(k));
}

TEST(LeastBending, LeavesVerticesAndBoundariesWhereTheyAre) {
    const Sample sample(stirred(shape("plate", 3), 0.02, [](Point point) {
        point[2] = 0.3 * point[0] * point[0];
        return point;
    }));
    const MeshLattice bent = sample.bent();
    double moved = 0;
    for (std::size_t k = 0; k < bent.numbers().count(); ++k)
        moved = std::max(moved, (bent.point(k) - sample.limit.point(k)).norm());
    EXPECT_GT(moved, 1e-6);
    for (const VertexId vertex : sample.mesh.vertices())
        EXPECT_EQ(bent.point(at(vertex)), sample.limit.point(at(vertex)));
    for (const EdgeId edge : sample.mesh.edges())
        for (int k = 0; sample.mesh.is_boundary(edge) && k <= 4; ++k) {
            const std::size_t number = bent.numbers()(sample.mesh.halfedge_handle(edge, 0), k, 0);
            EXPECT_EQ(bent.point(number), sample.limit.point(number));
        }
}

TEST(LeastBending, KeepsPlanesPlane) {
    const Sample sample(stirred(shape("plate", 3), 0.05, [](Point point) {
        point[2] = 0.5 * point[0];
        return point;
    }));
    const MeshLattice bent = sample.bent();
    for (std::size_t k = 0; k < bent.numbers().count(); ++k)
        EXPECT_NEAR(bent.point(k)[2], sample.limit.point(k)[2], 1e-12);
}

TEST(LeastBending, IsTheSameOnAnyNumberOfThreads) {
    const Sample sample(shape("genus2", 6));
    const MeshLattice one = sample.bent(1);
    const MeshLattice three = sample.bent(3);
    for (std::size_t k = 0; k < one.numbers().count(); ++k)
        ASSERT_EQ(one.point(k), three.point(k));
}

TEST(LeastBending, BelievesNoQuadsThatAreFarFromFlat) {
    // All quads of this cube are bent too much for any tangent plane.
    const Sample sample(shape("sphere", 1));
    const MeshLattice bent = sample.bent();
    for (std::size_t k = 0; k < bent.numbers().count(); ++k)
        EXPECT_TRUE(std::isfinite(bent.point(k).sqrnorm()));
}

} // namespace
} // namespace qm
