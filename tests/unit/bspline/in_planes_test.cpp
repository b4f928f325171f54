#include "base/at.h"
#include "bspline/reference/lattice/lagrange.h"
#include "bspline/reference/planes/in_planes.h"
#include "bspline/reference/planes/plane_corners.h"
#include "support/grid_layout.h"
#include "support/limit_sample.h"
#include "support/rounded_box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace qm {
namespace {

using test::LimitSample;
using test::RoundedBox;

constexpr double flatness = 1e-5;

/// A rounded box whose surface lies in the planes of its sides.
struct FlatBox {
    LimitSample sample;
    PlaneCorners corners{sample.limit, sample.sharpness(), flatness, 1};
    MeshLattice flat = sample.limit;

    FlatBox(int fillet, int sides, unsigned jobs = 1) : sample(RoundedBox(fillet, sides).mesh()) {
        layInPlanes(flat, corners, sample.isCrease, jobs);
    }

    [[nodiscard]] double largestDistance(const MeshLattice& lattice) const {
        double largest = 0;
        for (const FaceId face : sample.mesh.faces()) {
            const int part = corners.partOf(face);
            if (part == PlaneParts::none) continue;
            for (const auto& point : lattice.points(face))
                largest = std::max(largest, std::abs(corners.plane(part).distance(qm::point(point))));
        }
        return largest;
    }
};

TEST(InPlanes, TheSurfaceOverPlanePartsIsPlane) {
    for (const int sides : {1, 2, 3, 8}) {
        const FlatBox box(4, sides);
        EXPECT_GT(box.largestDistance(box.sample.limit), 1e-3) << sides;
        EXPECT_LT(box.largestDistance(box.flat), 1e-9) << sides;
    }
}

TEST(InPlanes, SurfacesBesidePlanePartsAreTangentToThem) {
    const FlatBox box(4, 3);
    const QuadMesh& mesh = box.sample.mesh;
    std::size_t outlines = 0;
    for (const HalfedgeId side : mesh.halfedges()) {
        const int part = box.corners.partOf(mesh.face_handle(mesh.opposite_halfedge_handle(side)));
        if (part == PlaneParts::none || box.corners.partOf(mesh.face_handle(side)) == part) continue;
        ++outlines;
        for (int k = 0; k <= 4; ++k) { // the derivative across the outline, into the fillet
            Point inwards(0, 0, 0);
            for (int depth = 0; depth <= 4; ++depth)
                inwards += lagrangeAtEnd(4, 0)[at(depth)][1] * box.flat.point(side, k, depth);
            EXPECT_NEAR(inwards.normalized() | box.corners.plane(part).normal, 0, 1e-9);
        }
    }
    EXPECT_EQ(outlines, at(6 * 4 * 3));
}

TEST(InPlanes, QuadsThatTouchAPartWithACornerAreTangentToItThere) {
    const FlatBox box(4, 3);
    const QuadMesh& mesh = box.sample.mesh;
    for (const HalfedgeId leaving : mesh.halfedges()) {
        const int part = box.corners.partAtCorner(leaving);
        if (part == PlaneParts::none) continue;
        EXPECT_NEAR(box.flat.derivative(leaving).normalized() | box.corners.plane(part).normal, 0, 1e-9);
    }
}

TEST(InPlanes, VerticesAndWhatDoesNotTouchThemStay) {
    const FlatBox box(6, 3);
    const QuadMesh& mesh = box.sample.mesh;
    std::size_t away = 0;
    for (const FaceId face : mesh.faces()) {
        bool touches = false;
        for (const VertexId corner : mesh.fv_range(face)) {
            touches = touches || box.corners.isBound(corner);
            EXPECT_EQ(box.flat.point(at(corner)), box.sample.limit.point(at(corner)));
        }
        if (touches) continue;
        ++away;
        EXPECT_EQ(box.flat.points(face), box.sample.limit.points(face));
    }
    EXPECT_GT(away, 0U);
}

TEST(InPlanes, TheResultDoesNotDependOnTheNumberOfThreads) {
    const FlatBox one(4, 40, 1);
    const FlatBox three(4, 40, 3);
    for (std::size_t k = 0; k < one.flat.numbers().count(); ++k)
        EXPECT_EQ(one.flat.point(k), three.flat.point(k));
}

TEST(InPlanes, VerticesBetweenPartsAreBoundToNone) {
    // Two plane halves that meet at 10 degrees, smoothly.
    const auto bent = [](double i, double j) { return Point(i, j, 0.17 * std::max(0.0, i - 6)); };
    const LimitSample sample(test::makeMesh({12, 8, bent}));
    const PlaneCorners corners(sample.limit, sample.sharpness(), flatness, 1);
    for (const VertexId vertex : sample.mesh.vertices()) {
        const bool isBetween = sample.mesh.point(vertex)[0] == 6;
        EXPECT_EQ(corners.isBound(vertex), !isBetween);
    }
}

} // namespace
} // namespace qm
