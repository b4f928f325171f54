#include "bspline/reference/limit/edge_curves.h"
#include "support/limit_sample.h"

#include <gtest/gtest.h>

#include <array>

namespace qm {
namespace {

TEST(EdgeCurves, AreTangentToASphereHoweverUnevenItsVerticesAre) {
    QuadMesh mesh = test::shape("sphere", 4);
    for (const VertexId vertex : mesh.vertices()) {
        const Point at = mesh.point(vertex);
        mesh.set_point(vertex, (at + Point(0.1 * at[1], 0.2 * at[0] * at[2], 0)).normalized());
    }
    const test::LimitSample sample(mesh);
    const EdgeCurves curves(sample.mesh, sample.sharpness(), nullptr);
    for (const HalfedgeId halfedge : sample.mesh.halfedges()) {
        const std::array<Point, 4> points = curves.above(halfedge);
        const double length = sample.mesh.calc_edge_length(halfedge);
        EXPECT_NEAR((points[1] - points[0]) | points[0], 0, 1e-12);
        EXPECT_NEAR((points[1] - points[0]).norm(), length / 3, 1e-12);
        EXPECT_NEAR((points[2] - points[3]) | points[3], 0, 1e-12);
    }
}

} // namespace
} // namespace qm
