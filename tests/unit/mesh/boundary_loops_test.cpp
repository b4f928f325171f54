#include "mesh/boundary_loops.h"
#include "mesh/triangles/triangle_edges.h"
#include "shape/shape.h"

#include <gtest/gtest.h>

namespace qm {
namespace {

TEST(BoundaryLoops, AreNoneOnAClosedMesh) {
    EXPECT_TRUE(boundaryLoops(makeShape("cube")).empty());
}

TEST(BoundaryLoops, ComeWithLengthsTheLongestFirst) {
    const QuadMesh plate = makeShape("plate"); // 5 x 3, with a round hole
    const std::vector<BoundaryLoop> loops = boundaryLoops(plate);
    ASSERT_EQ(loops.size(), 2U);
    EXPECT_NEAR(loops[0].length, 16, 1e-12);
    EXPECT_LT(loops[1].length, loops[0].length);
    std::size_t edges = 0;
    for (const EdgeId edge : plate.edges())
        edges += plate.is_boundary(edge) ? 1 : 0;
    EXPECT_EQ(loops[0].edges + loops[1].edges, edges);
    for (const BoundaryLoop& loop : loops)
        EXPECT_TRUE(plate.is_boundary(loop.vertex));
}

Triangles square() {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

TEST(TriangleEdges, BoundaryLoopsAreCounted) {
    EXPECT_EQ(boundaryLoopCount(square()), 1U);
    Triangles two = square();
    for (const Point& point : square().points)
        two.points.push_back(point + Point(5, 0, 0));
    two.faces.push_back({4, 5, 6});
    two.faces.push_back({4, 6, 7});
    EXPECT_EQ(boundaryLoopCount(two), 2U);
    const Triangles tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    EXPECT_EQ(boundaryLoopCount(tetrahedron), 0U);
}

} // namespace
} // namespace qm
