#include "mesh/dihedral.h"
#include "mesh/quad_geometry.h"
#include "remesh/draw_to_scan.h"
#include "remesh/scan_equations.h"
#include "remesh/unfold_quads.h"
#include "shape/scan.h"
#include "shape/shape.h"
#include "support/grid_layout.h"
#include "support/true_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace qm {
namespace {

/// Moves every vertex to the mean of itself and its surroundings, as remeshers do.
QuadMesh withCutOffCorners(QuadMesh mesh) {
    const QuadMesh before = mesh;
    for (const VertexId vertex : mesh.vertices()) {
        if (mesh.is_boundary(vertex)) continue;
        Point sum = before.point(vertex) * mesh.valence(vertex);
        for (const VertexId other : before.vv_range(vertex))
            sum += before.point(other);
        mesh.set_point(vertex, sum / (2.0 * mesh.valence(vertex)));
    }
    return mesh;
}

double maxDistance(const QuadMesh& mesh, const std::string& part) {
    const auto surface = test::trueSurface(part);
    double max = 0;
    for (const VertexId vertex : mesh.vertices())
        max = std::max(max, surface->nearest(mesh.point(vertex)).distance);
    return max;
}

TEST(DrawToScan, WhatWasCutOffAtEdgesAndCornersComesBack) {
    for (const char* part : {"cube", "block", "cylinder"}) {
        const QuadMesh cut = withCutOffCorners(makeShape(part, {.resolution = 6}));
        const QuadMesh drawn = drawToScan(cut, makeScan(part, 20000), 2);
        EXPECT_GT(maxDistance(cut, part), 0.02) << part;
        EXPECT_LT(maxDistance(drawn, part), 0.25 * maxDistance(cut, part)) << part;
    }
}

TEST(DrawToScan, SharpEdgesAreSharpAgain) {
    const QuadMesh cut = withCutOffCorners(makeShape("cube", {.resolution = 6}));
    const QuadMesh drawn = drawToScan(cut, makeScan("cube", 20000), 1);
    const auto sharp = [](const QuadMesh& mesh) {
        return std::ranges::count_if(dihedralAngles(mesh),
                                     [](double angle) { return angle > 85 * std::numbers::pi / 180; });
    };
    EXPECT_EQ(sharp(cut), 0);
    EXPECT_EQ(sharp(drawn), 12 * 6);
}

TEST(DrawToScan, NoiseAndHolesOfTheScanChangeLittle) {
    const QuadMesh cut = withCutOffCorners(makeShape("cube", {.resolution = 6}));
    Triangles scan = makeScan("cube", 20000);
    addNoise(scan, 0.004, 1);
    std::erase_if(scan.faces, [&](const auto& face) {
        const Point& corner = scan.points[static_cast<std::size_t>(face[0])];
        return (corner - Point(0.5, 0.5, 1)).norm() < 0.2;
    });
    EXPECT_LT(maxDistance(drawToScan(cut, scan, 1), "cube"), 0.4 * maxDistance(cut, "cube"));
}

TEST(DrawToScan, FoldedQuadsUnfold) {
    QuadMesh mesh = makeShape("sphere", {.resolution = 8});
    // Exchanges the ends of an edge.
    const HalfedgeId edge = mesh.halfedge_handle(VertexId(0));
    const Point from = mesh.point(VertexId(0));
    mesh.set_point(VertexId(0), mesh.point(mesh.to_vertex_handle(edge)));
    mesh.set_point(mesh.to_vertex_handle(edge), from);
    const auto folded = [](const QuadMesh& of) {
        return std::ranges::count_if(of.faces(), [&](FaceId face) {
            const auto corners = cornersOf(of, face);
            Point middle{0, 0, 0};
            for (const VertexId corner : corners)
                middle += of.point(corner);
            return std::ranges::any_of(halvesOf(of, face), [&](const Triangle& half) {
                const auto normal = triangleNormal(half);
                return !normal || (*normal | middle) < 0;
            });
        });
    };
    EXPECT_GT(folded(mesh), 0);
    EXPECT_EQ(folded(drawToScan(mesh, makeScan("sphere", 20000), 1)), 0);
}

/// A net of 4 rows and 12 columns around the corner of an L whose arms are one wide and six long. Columns
/// lean more and more towards the corner.
QuadMesh leaningNet() {
    return test::makeMesh({12, 4, [](double i, double j) {
                               const double across = j / 4;
                               const double share = i / 12;
                               const double along =
                                   2 * share + 0.8 * share * (1 - share) * (1 - 2 * across) - 1;
                               const double far = across + std::abs(along) * (6 - across);
                               return along < 0 ? Point(across, far, 0) : Point(far, across, 0);
                           }});
}

TEST(DrawToScan, QuadsThatEvenNetsFoldAroundACornerUnfold) {
    const Triangles corner{{{0, 6, 0}, {0, 0, 0}, {6, 0, 0}, {6, 1, 0}, {1, 1, 0}, {1, 6, 0}},
                           {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}}};
    const TriangleSurface surface(corner);
    const auto folded = [&](const QuadMesh& mesh) {
        return std::ranges::count_if(mesh.faces(),
                                     [&](FaceId face) { return uprightness(mesh, face, surface, 1) < 0; });
    };
    EXPECT_GT(folded(leaningNet()), 0);
    EXPECT_EQ(folded(drawToScan(leaningNet(), corner, 1)), 0);
}

TEST(DrawToScan, WhatHangsOverASharpEdgeIsPulledBack) {
    // A quad beyond the upper edge of a cube, in the plane of its upper side.
    QuadMesh mesh;
    std::vector<VertexId> corners;
    for (const auto& [x, y] : {std::pair(1.0, 0.4), {1.2, 0.4}, {1.2, 0.6}, {1.0, 0.6}})
        corners.push_back(mesh.add_vertex({x, y, 1}));
    mesh.add_face(corners);
    const TriangleSurface cube(makeScan("cube", 2000));
    std::size_t inside = 0;
    for (const ScanEquation& equation : scanEquations(mesh, cube, {}, 0.5, 1)) {
        if (equation.vertices[2] == equation.vertices[3]) continue; // equation of a side of the quad
        ++inside;
        EXPECT_NEAR(std::abs(equation.direction[0]), 1, 1e-6);
        EXPECT_LT(equation.direction[0] * equation.distance, -0.03);
    }
    EXPECT_EQ(inside, 9U);
}

TEST(DrawToScan, BoundariesGoToTheScansOwn) {
    QuadMesh mesh = makeShape("plate", {.resolution = 6});
    const QuadMesh before = mesh;
    for (const VertexId vertex : mesh.vertices()) // some vertices outside, some inside
        mesh.set_point(vertex, mesh.point(vertex) * (vertex.idx() % 2 == 0 ? 1.01 : 0.99));
    const QuadMesh drawn = drawToScan(mesh, makeScan("plate", 20000), 1);
    const auto off = [&](const QuadMesh& of) {
        double sum = 0;
        for (const VertexId vertex : of.vertices())
            if (of.is_boundary(vertex)) sum += test::trueSurface("plate")->nearest(of.point(vertex)).distance;
        return sum;
    };
    EXPECT_LT(off(drawn), 0.3 * off(mesh));
}

TEST(DrawToScan, ThreadsDoNotMatter) {
    const QuadMesh mesh = withCutOffCorners(makeShape("block", {.resolution = 4}));
    const Triangles scan = makeScan("block", 5000);
    const QuadMesh one = drawToScan(mesh, scan, 1);
    const QuadMesh many = drawToScan(mesh, scan, 4);
    for (const VertexId vertex : mesh.vertices())
        EXPECT_EQ(one.point(vertex), many.point(vertex));
}

} // namespace
} // namespace qm
