#include "base/at.h"
#include "bspline/reference/even_speeds.h"
#include "support/limit_sample.h"

#include <gtest/gtest.h>

#include <cmath>

namespace qm {
namespace {

using testing::LimitSample;
using testing::shape;
using testing::stirred;

TEST(EvenSpeeds, AreThoseOfArcsBetweenTheVertices) {
    const LimitSample sample(stirred(shape("torus", 4), 0.04, [](const Point& point) { return point; }));
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
    const LimitSample sample(shape("tube", 4));
    MeshLattice even = sample.limit;
    evenSpeeds(even, 1);
    for (std::size_t k = 0; k < even.numbers().count(); ++k)
        EXPECT_LT((even.point(k) - sample.limit.point(k)).norm(), 1e-3);
}

TEST(EvenSpeeds, AreTheSameOnAnyNumberOfThreads) {
    const LimitSample sample(shape("genus2", 6));
    MeshLattice one = sample.limit;
    MeshLattice three = sample.limit;
    evenSpeeds(one, 1);
    evenSpeeds(three, 3);
    for (std::size_t k = 0; k < one.numbers().count(); ++k)
        ASSERT_EQ(one.point(k), three.point(k));
}

} // namespace
} // namespace qm
