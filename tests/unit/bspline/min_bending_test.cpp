#include "base/at.h"
#include "bspline/reference/bending/min_bending.h"
#include "support/limit_sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

using test::LimitSample;
using test::shape;
using test::stirred;

MeshLattice bent(const LimitSample& sample, unsigned jobs = 1) {
    MeshLattice lattice = sample.limit;
    minimiseBending(lattice, sample.rules, sample.noPlanes(), jobs);
    return lattice;
}

/// Root mean square distance from the unit sphere; single distances may be small by chance.
double fromSphere(const MeshLattice& lattice) {
    double sum = 0;
    for (std::size_t k = 0; k < lattice.numbers().count(); ++k)
        sum += std::pow(lattice.point(k).norm() - 1, 2);
    return std::sqrt(sum / static_cast<double>(lattice.numbers().count()));
}

TEST(MinBending, BringsTheSurfaceNearerToASphere) {
    const auto onto = [](const Point& point) { return point / point.norm(); };
    for (const double by : {0.0, 0.02}) {
        const LimitSample sample(stirred(shape("sphere", 8), by, onto));
        EXPECT_LT(fromSphere(bent(sample)), 0.5 * fromSphere(sample.limit)) << by;
    }
}

TEST(MinBending, TwistsQuadsOverSkewLines) {
    // A saddle is twisted along lines that run at half right angles to its bends.
    const auto onto = [](Point point) {
        point[2] = 0.5 * point[0] * point[1];
        return point;
    };
    const LimitSample sample(stirred(shape("plate", 4), 0.03, onto));
    const MeshLattice surface = bent(sample);
    const auto offSaddle = [&](const MeshLattice& lattice) {
        double sum = 0;
        for (const FaceId face : sample.mesh.faces()) {
            const bool isInside = std::ranges::none_of(
                sample.mesh.fv_range(face), [&](VertexId vertex) { return sample.mesh.is_boundary(vertex); });
            const Point middle = lattice.point(face, 2, 2);
            if (isInside) sum += std::pow(middle[2] - 0.5 * middle[0] * middle[1], 2);
        }
        return std::sqrt(sum);
    };
    EXPECT_LT(offSaddle(surface), 0.7 * offSaddle(sample.limit));
}

TEST(MinBending, LeavesVerticesAndBoundariesWhereTheyAre) {
    const LimitSample sample(stirred(shape("plate", 3), 0.02, [](Point point) {
        point[2] = 0.3 * point[0] * point[0];
        return point;
    }));
    const MeshLattice surface = bent(sample);
    double moved = 0;
    for (std::size_t k = 0; k < surface.numbers().count(); ++k)
        moved = std::max(moved, (surface.point(k) - sample.limit.point(k)).norm());
    EXPECT_GT(moved, 1e-6);
    for (const VertexId vertex : sample.mesh.vertices())
        EXPECT_EQ(surface.point(at(vertex)), sample.limit.point(at(vertex)));
    for (const EdgeId edge : sample.mesh.edges())
        for (int k = 0; sample.mesh.is_boundary(edge) && k <= 4; ++k) {
            const std::size_t number = surface.numbers()(sample.mesh.halfedge_handle(edge, 0), k, 0);
            EXPECT_EQ(surface.point(number), sample.limit.point(number));
        }
}

TEST(MinBending, KeepsPlanesPlane) {
    const LimitSample sample(stirred(shape("plate", 3), 0.05, [](Point point) {
        point[2] = 0.5 * point[0];
        return point;
    }));
    const MeshLattice surface = bent(sample);
    for (std::size_t k = 0; k < surface.numbers().count(); ++k)
        EXPECT_NEAR(surface.point(k)[2], sample.limit.point(k)[2], 1e-12);
}

TEST(MinBending, IsTheSameOnAnyNumberOfThreads) {
    const LimitSample sample(shape("genus2", 6));
    const MeshLattice one = bent(sample, 1);
    const MeshLattice three = bent(sample, 3);
    for (std::size_t k = 0; k < one.numbers().count(); ++k)
        ASSERT_EQ(one.point(k), three.point(k));
}

TEST(MinBending, BelievesNoQuadsThatAreFarFromFlat) {
    // All quads of this cube are bent too much for any tangent plane.
    const LimitSample sample(shape("sphere", 1));
    const MeshLattice surface = bent(sample);
    for (std::size_t k = 0; k < surface.numbers().count(); ++k)
        EXPECT_TRUE(std::isfinite(surface.point(k).sqrnorm()));
}

} // namespace
} // namespace qm
