#include "bspline/network/crease_paths.h"
#include "bspline/network/creases.h"
#include "mesh/dihedral.h"
#include "shape/shape.h"
#include "support/quad_layout.h"

#include <gtest/gtest.h>

namespace qm {
namespace {

/// The paths of a sample part in which every quad is a segment.
std::vector<std::vector<VertexId>> paths(const char* name, int resolution) {
    const QuadMesh mesh = makeShape(name, {.resolution = resolution});
    const Layout layout = test::segmentPerQuad(mesh);
    return creasePaths(mesh, markBorders(mesh, borderEdges(mesh, layout), dihedralAngles(mesh), 0.6));
}

TEST(CreasePaths, RunFromCornerToCorner) {
    const auto found = paths("cube", 3);
    EXPECT_EQ(found.size(), 12);
    for (const auto& path : found) {
        EXPECT_EQ(path.size(), 4);
        EXPECT_NE(path.front(), path.back());
    }
}

TEST(CreasePaths, AreClosedWhereNoOthersMeetThem) {
    const auto found = paths("cylinder", 3);
    EXPECT_EQ(found.size(), 2);
    for (const auto& path : found) {
        EXPECT_GT(path.size(), 8);
        EXPECT_EQ(path.front(), path.back());
    }
}

TEST(CreasePaths, DoNotRunAlongTheBoundary) {
    EXPECT_TRUE(paths("torus", 6).empty());
    const QuadMesh mesh = makeShape("random-open", {});
    for (const auto& path : paths("random-open", 0))
        for (std::size_t k = 1; k < path.size(); ++k)
            EXPECT_FALSE(mesh.is_boundary(mesh.edge_handle(mesh.find_halfedge(path[k - 1], path[k]))));
}

} // namespace
} // namespace qm
