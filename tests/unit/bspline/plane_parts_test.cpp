#include "base/at.h"
#include "bspline/reference/planes/plane_parts.h"
#include "support/grid_layout.h"
#include "support/limit_sample.h"
#include "support/rounded_box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <vector>

namespace qm {
namespace {

using test::Grid;
using test::RoundedBox;

PlaneParts partsOf(const QuadMesh& mesh) {
    constexpr double flatness = 1e-5;
    const auto isCrease = test::creasesAndBoundary(mesh, std::vector<bool>(mesh.n_edges()));
    return planeParts(mesh, isCrease, flatness, 2);
}

std::size_t quadsIn(const PlaneParts& parts) {
    return parts.ofFace.size() - static_cast<std::size_t>(std::ranges::count(parts.ofFace, PlaneParts::none));
}

std::size_t numberOf(const PlaneParts& parts) {
    std::set<int> different(parts.ofFace.begin(), parts.ofFace.end());
    different.erase(PlaneParts::none);
    return different.size();
}

/// A column of so many sides, with rows of quads along each; the sides are round, or plane facets.
Grid column(int sides, int perSide, int rows, bool hasFacets) {
    return {sides * perSide, rows, [=](double i, double j) {
                const double turn = 2 * std::numbers::pi / sides;
                const double side = hasFacets ? std::floor(i / perSide) : i / perSide;
                const double along = i / perSide - side;
                const auto corner = [&](double k) {
                    return Point(std::cos(k * turn), std::sin(k * turn), 0);
                };
                return (1 - along) * corner(side) + along * corner(side + 1) + Point(0, 0, 0.1 * j);
            }};
}

TEST(PlaneParts, AreTheSidesOfARoundedBox) {
    for (const int flat : {1, 2, 3, 8}) {
        const RoundedBox box(4, flat);
        const PlaneParts parts = partsOf(box.mesh());
        EXPECT_EQ(numberOf(parts), 6U) << flat;
        EXPECT_EQ(quadsIn(parts), at(6 * flat * flat)) << flat;
        for (const FaceId face : box.mesh().faces()) {
            const int part = parts.ofFace[at(face)];
            if (part == PlaneParts::none) continue;
            for (const VertexId corner : box.mesh().fv_range(face))
                EXPECT_NEAR(parts.planes[at(part)].distance(box.mesh().point(corner)), 0, 1e-9);
            EXPECT_GT(parts.planes[at(part)].offset, 0); // the normal points outwards, as those of the quads
        }
    }
}

TEST(PlaneParts, RoundShapesHaveNone) {
    for (const char* name : {"sphere", "torus", "tube"})
        EXPECT_EQ(quadsIn(partsOf(test::shape(name, 8))), 0U) << name;
}

TEST(PlaneParts, FacetsOfSomethingRoundAreNone) {
    const QuadMesh mesh = test::makeMesh(column(12, 4, 8, true));
    const PlaneParts parts = partsOf(mesh);
    // Those at both ends of the sheet do not continue in other facets all around.
    EXPECT_EQ(quadsIn(parts), 2U * 4 * 8);
    EXPECT_EQ(numberOf(parts), 2U);
}

TEST(PlaneParts, RowsOfQuadsAlongACylinderAreNone) {
    EXPECT_EQ(quadsIn(partsOf(test::makeMesh(column(24, 1, 1, false)))), 0U);
}

TEST(PlaneParts, WhatLeavesThemSlowlyDoesNotHideThem) {
    // Parts that begin where the mesh leaves the plane reach into it, and turn.
    for (const double size : {1e-6, 2e-6, 4e-6, 1e-5, 1e-4}) {
        const auto leaving = [=](double i, double j) {
            const auto rise = [](double steps) { return steps > 0 ? steps * steps * steps : 0; };
            return Point(i, j, size * (rise(i - 16) + 0.9 * rise(4 - i) - 0.6 * rise(4 - j)));
        };
        const QuadMesh mesh = test::makeMesh({24, 24, leaving});
        const PlaneParts parts = partsOf(mesh);
        for (const FaceId face : mesh.faces()) {
            const Point middle = mesh.calc_face_centroid(face);
            if (middle[0] < 4 || middle[0] > 16 || middle[1] < 4) continue;
            EXPECT_NE(parts.ofFace[at(face)], PlaneParts::none) << size << ' ' << middle;
        }
    }
}

TEST(PlaneParts, FewQuadsThatLieInOnePlaneByChanceAreNone) {
    // A ridge beside a flat of two quads by two, which is not wider than what continues it.
    const auto dented = [](double i, double j) {
        const bool isFlat = i >= 2 && i <= 4 && j >= 2 && j <= 4;
        return Point(i, j, isFlat ? 0 : 0.1 * std::sin(5 * i + 3 * j));
    };
    EXPECT_EQ(quadsIn(partsOf(test::makeMesh({6, 6, dented}))), 0U);
}

TEST(PlaneParts, EndAtCreases) {
    const QuadMesh mesh = test::makeMesh({16, 8, [](double i, double j) { return Point(i, j, 0); }});
    auto isCrease = test::creasesAndBoundary(mesh, std::vector<bool>(mesh.n_edges()));
    EXPECT_EQ(numberOf(planeParts(mesh, isCrease, 1e-5, 1)), 1U);
    for (const EdgeId edge : mesh.edges())
        if (mesh.calc_edge_midpoint(edge)[0] == 8) isCrease[at(edge)] = true;
    const PlaneParts divided = planeParts(mesh, isCrease, 1e-5, 1);
    EXPECT_EQ(numberOf(divided), 2U);
    EXPECT_EQ(quadsIn(divided), mesh.n_faces());
}

} // namespace
} // namespace qm
