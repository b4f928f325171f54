#include "prune/vertex_room.h"
#include "support/star_mesh.h"

#include <gtest/gtest.h>

#include <vector>

namespace qm::test {
namespace {

std::vector<RoomSector> roomOf(const QuadMesh& mesh, double minCorner,
                               const std::vector<HalfedgeId>& sharp = {}) {
    std::vector<double> angles(mesh.n_edges());
    for (const HalfedgeId halfedge : sharp)
        angles[static_cast<std::size_t>(mesh.edge_handle(halfedge).idx())] = 1;
    return roomAt(mesh, angles, VertexId(0), minCorner);
}

std::size_t maxMissing(int quads, double minCorner) {
    const auto sectors = roomOf(star(quads), minCorner);
    EXPECT_EQ(sectors.size(), 1U);
    EXPECT_EQ(sectors.front().edges.size(), static_cast<std::size_t>(quads));
    return sectors.front().maxMissing;
}

HalfedgeId spoke(const QuadMesh& mesh, int k) {
    return mesh.find_halfedge(VertexId(0), VertexId(1 + k));
}

TEST(VertexRoom, OneSideMayPassWhereItLeavesTheOtherCornersEnough) {
    EXPECT_EQ(maxMissing(3, 25), 0U) << "the other corner would be flat";
    EXPECT_EQ(maxMissing(5, 25), 1U) << "60 degrees are left; beside two sides, none";
    EXPECT_EQ(maxMissing(6, 25), 1U);
    EXPECT_EQ(maxMissing(8, 25), 1U) << "30 degrees";
    EXPECT_EQ(maxMissing(8, 31), 0U);
    EXPECT_EQ(maxMissing(5, 0), 5U) << "anything goes";
}

TEST(VertexRoom, SharpEdgesPartTangentPlanes) {
    const QuadMesh mesh = star(6);
    const auto one = roomOf(mesh, 25, {spoke(mesh, 0)});
    ASSERT_EQ(one.size(), 1U) << "a crease that ends there parts nothing";
    EXPECT_EQ(one.front().edges.size(), 6U);
    const auto halves = roomOf(mesh, 25, {spoke(mesh, 0), spoke(mesh, 3)});
    ASSERT_EQ(halves.size(), 2U);
    for (const RoomSector& half : halves) {
        EXPECT_EQ(half.edges.size(), 2U);
        EXPECT_EQ(half.maxMissing, 0U) << "half a turn is all there is";
    }
    const auto unequal = roomOf(mesh, 25, {spoke(mesh, 1), spoke(mesh, 2)});
    ASSERT_EQ(unequal.size(), 1U) << "between the two there is no edge";
    EXPECT_EQ(unequal.front().edges.size(), 4U);
    EXPECT_EQ(unequal.front().maxMissing, 1U) << "300 degrees";
}

TEST(VertexRoom, AnglesBesideFoldedQuadsAreNotBelieved) {
    QuadMesh mesh = star(6);
    const HalfedgeId first = spoke(mesh, 0);
    const VertexId outer = mesh.to_vertex_handle(mesh.next_halfedge_handle(first));
    mesh.set_point(outer, (mesh.point(VertexId(1)) + mesh.point(VertexId(2))) / 2); // in line with both
    EXPECT_EQ(roomOf(mesh, 25, {first, spoke(mesh, 3)}).size(), 1U);
    EXPECT_EQ(roomOf(mesh, 25, {spoke(mesh, 2), spoke(mesh, 4)}).size(), 2U) << "others are";
}

TEST(VertexRoom, BeyondTheBoundaryThereIsNone) {
    const auto corner = roomOf(star(3, 270), 25);
    ASSERT_EQ(corner.size(), 1U);
    EXPECT_EQ(corner.front().edges.size(), 2U);
    EXPECT_EQ(corner.front().maxMissing, 1U) << "a straight side and a right angle";
    EXPECT_EQ(roomOf(star(3, 190), 25).front().maxMissing, 0U);
}

TEST(VertexRoom, ASideThatIsLeftAloneTurnsByARightAngleAtMost) {
    EXPECT_EQ(roomOf(star(2, 95), 25).front().maxMissing, 1U);
    EXPECT_EQ(roomOf(star(2, 85), 25).front().maxMissing, 0U);
    EXPECT_EQ(roomOf(star(2, 265), 25).front().maxMissing, 1U);
    EXPECT_EQ(roomOf(star(2, 275), 25).front().maxMissing, 0U);
}

} // namespace
} // namespace qm::test
