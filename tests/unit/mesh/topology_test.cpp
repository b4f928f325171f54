#include "mesh/soup/build_mesh.h"
#include "mesh/topology.h"
#include "shape/quad_list.h"
#include "shape/shape.h"
#include "shape/voxels.h"
#include "support/track_along.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace qm {
namespace {

VertexId vertex(int k) {
    return VertexId(k);
}

/// A flat grid; vertex (i, j) has number j * (columns + 1) + i.
QuadMesh flatGrid(int columns, int rows) {
    const GridTopology grid{.columns = columns, .rows = rows};
    std::vector<Point> points;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            points.emplace_back(i, j, 0);
    return buildMesh(points, grid.quads());
}

QuadMesh meshOf(const Voxels& voxels) {
    const QuadList list = voxelSurface(voxels);
    return buildMesh(list.points, list.quads);
}

TEST(Regularity, OfAGridIsEverywhere) {
    const QuadMesh mesh = flatGrid(3, 3);
    for (const VertexId v : mesh.vertices())
        EXPECT_TRUE(isRegular(mesh, v)) << v.idx();
    EXPECT_TRUE(extraordinaryVertices(mesh).empty());
}

TEST(Regularity, OfACubeIsNowhere) {
    const QuadMesh mesh = meshOf(voxelBox(1, 1, 1));
    EXPECT_EQ(extraordinaryVertices(mesh).size(), 8U);
}

TEST(Regularity, OfABoundaryVertexDependsOnItsFaces) {
    // One to four squares around the middle of a 2 x 2 grid.
    const QuadMesh whole = flatGrid(2, 2);
    std::vector<Point> points;
    for (const VertexId v : whole.vertices())
        points.push_back(whole.point(v));
    const std::vector<std::array<int, 4>> quads{{0, 1, 4, 3}, {1, 2, 5, 4}, {4, 5, 8, 7}, {3, 4, 7, 6}};
    for (std::size_t count = 1; count <= 4; ++count) {
        const QuadMesh part = buildMesh(points, {quads.begin(), quads.begin() + std::ptrdiff_t(count)});
        EXPECT_EQ(isRegular(part, vertex(4)), count != 3) << count;
        EXPECT_EQ(extraordinaryVertices(part).size(), count == 3 ? 1U : 0U) << count;
    }
}

TEST(Regularity, OfAnIsolatedVertex) {
    const QuadMesh mesh = buildMesh({{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 2, 3, 4}});
    EXPECT_TRUE(isRegular(mesh, vertex(1)));
    EXPECT_EQ(mesh.n_vertices(), 5U);
}

TEST(Regularity, BothWaysOfAskingAgree) {
    for (const ShapeKind& kind : shapeKinds()) {
        const QuadMesh mesh = makeShape(kind.name, {.resolution = 2});
        const std::vector<VertexId> extraordinary = extraordinaryVertices(mesh);
        EXPECT_TRUE(std::is_sorted(extraordinary.begin(), extraordinary.end()));
        for (const VertexId v : mesh.vertices())
            EXPECT_NE(isRegular(mesh, v), std::binary_search(extraordinary.begin(), extraordinary.end(), v))
                << kind.name;
    }
}

TEST(StraightOn, CrossesAGrid) {
    const QuadMesh mesh = flatGrid(4, 3);
    HalfedgeId halfedge = mesh.find_halfedge(vertex(5), vertex(6)); // along the second row
    ASSERT_TRUE(halfedge.is_valid());
    for (const int next : {7, 8, 9}) {
        ASSERT_TRUE(continuesStraight(mesh, mesh.to_vertex_handle(halfedge)));
        halfedge = straightOn(mesh, halfedge);
        EXPECT_EQ(mesh.to_vertex_handle(halfedge), vertex(next));
    }
    EXPECT_FALSE(continuesStraight(mesh, mesh.to_vertex_handle(halfedge))); // the boundary
}

TEST(StraightOn, GoesBackTheSameWay) {
    const QuadMesh mesh = makeShape("torus", {.resolution = 2});
    for (const HalfedgeId halfedge : mesh.halfedges()) {
        const HalfedgeId next = straightOn(mesh, halfedge);
        EXPECT_EQ(mesh.from_vertex_handle(next), mesh.to_vertex_handle(halfedge));
        EXPECT_EQ(straightOn(mesh, mesh.opposite_halfedge_handle(next)),
                  mesh.opposite_halfedge_handle(halfedge));
    }
}

TEST(StraightOn, EndsAtExtraordinaryVertices) {
    const QuadMesh mesh = meshOf(voxelBox(1, 1, 1));
    for (const VertexId v : mesh.vertices())
        EXPECT_FALSE(continuesStraight(mesh, v));
}

TEST(Paths, HaveOneVertexMoreThanHalfedges) {
    const QuadMesh mesh = flatGrid(3, 3);
    const test::Path path{4, 5, 6, 10};
    EXPECT_EQ(test::numbers(verticesAlong(mesh, test::trackAlong(mesh, path).halfedges)), path);
    EXPECT_TRUE(verticesAlong(mesh, {}).empty());
}

TEST(ComponentsOfAMesh, AreNumberedByTheirLowestVertex) {
    Voxels voxels = voxelBox(1, 1, 1);
    voxels.insert({5, 0, 0});
    voxels.insert({0, 5, 0});
    QuadList list = voxelSurface(voxels);
    list.points.emplace_back(7, 7, 7);
    const QuadMesh mesh = buildMesh(list.points, list.quads);
    const Components parts = components(mesh);
    EXPECT_EQ(parts.count, 4);
    ASSERT_EQ(parts.ofVertex.size(), 25U);
    int highest = -1;
    for (const int part : parts.ofVertex) {
        EXPECT_LE(part, highest + 1);
        highest = std::max(highest, part);
    }
    for (const EdgeId edge : mesh.edges())
        EXPECT_EQ(parts.ofVertex[std::size_t(mesh.to_vertex_handle(mesh.halfedge_handle(edge, 0)).idx())],
                  parts.ofVertex[std::size_t(mesh.to_vertex_handle(mesh.halfedge_handle(edge, 1)).idx())]);
}

TEST(ComponentsOfAMesh, OfSolids) {
    for (const ShapeKind& kind : shapeKinds()) {
        if (std::string(kind.name) == "random-open") continue;
        EXPECT_EQ(components(makeShape(kind.name, {.resolution = 2})).count, 1) << kind.name;
    }
}

} // namespace
} // namespace qm
