#include "enumerate/paper/plain_graph.h"
#include "layout/layout.h"
#include "layout/quality.h"
#include "mesh/topology.h"
#include "support/layout_fault.h"
#include "support/message_of.h"
#include "support/polycube.h"
#include "support/random_graph.h"
#include "support/track_along.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace qm::test {
namespace {

Layout layoutAlong(const QuadMesh& mesh, const std::vector<Path>& paths) {
    std::vector<Track> tracks;
    tracks.reserve(paths.size());
    for (const Path& path : paths)
        tracks.push_back(trackAlong(mesh, path));
    const std::vector<double> flat(mesh.n_edges(), 0);
    return buildLayout(mesh, tracks, flat, flat);
}

Layout plainLayout(const QuadMesh& mesh) {
    const std::vector<double> flat(mesh.n_edges(), 0);
    return buildLayout(mesh, plainMotorcycleGraph(mesh, buildBaseComplex(mesh), flat).tracks, flat, flat);
}

std::string refusal(const QuadMesh& mesh, const std::vector<Path>& paths) {
    return messageOf([&] { (void)layoutAlong(mesh, paths); });
}

TEST(Layout, LeavesARectangleWhole) {
    const QuadMesh mesh = rectangle(3, 2);
    const Layout layout = layoutAlong(mesh, {});
    ASSERT_EQ(layout.segments.size(), 1U);
    EXPECT_TRUE(layout.tracks.empty());
    const Segment& segment = layout.segments[0];
    EXPECT_EQ(segment.size, (std::array{3, 2}));
    EXPECT_EQ(numbers(segment.corners), (Path{0, 3, 11, 8}));
    EXPECT_EQ(numbers(segment.sides[0]), (Path{0, 1, 2, 3}));
    EXPECT_EQ(numbers(segment.sides[1]), (Path{3, 7, 11}));
    EXPECT_EQ(numbers(segment.sides[2]), (Path{11, 10, 9, 8}));
    EXPECT_EQ(numbers(segment.sides[3]), (Path{8, 4, 0}));
    EXPECT_EQ(numbers(segment.faces), (Path{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(numbers(vertexGrid(mesh, segment)), (Path{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
}

TEST(Layout, CutsAlongTheTracks) {
    // A track straight down and one from its middle to the right form a T.
    const QuadMesh mesh = rectangle(2, 2);
    const Layout layout = layoutAlong(mesh, {{1, 4, 7}, {4, 5}});
    EXPECT_EQ(layoutFault(mesh, layout), "");
    ASSERT_EQ(layout.segments.size(), 3U);
    EXPECT_EQ(numbers(layout.segments[0].faces), (Path{0, 2}));
    EXPECT_EQ(numbers(layout.segments[1].faces), (Path{1}));
    EXPECT_EQ(numbers(layout.segments[2].faces), (Path{3}));
    EXPECT_EQ(layout.tracks.size(), 2U);
}

TEST(Layout, BeginsEverySegmentAtItsLowestCorner) {
    for (const QuadMesh& mesh : {quadMesh(polycube(bump(), 2)), quadMesh(polycube(box(1, 1, 1)))})
        for (const Segment& segment : plainLayout(mesh).segments)
            EXPECT_EQ(segment.corners[0], *std::min_element(segment.corners.begin(), segment.corners.end()));
}

TEST(Layout, HasASegmentForEverySideOfACube) {
    const QuadMesh mesh = quadMesh(polycube(box(1, 1, 1), 3));
    const Layout layout = plainLayout(mesh);
    EXPECT_EQ(layoutFault(mesh, layout), "");
    ASSERT_EQ(layout.segments.size(), 6U);
    for (const Segment& segment : layout.segments)
        EXPECT_EQ(segment.size, (std::array{3, 3}));
}

TEST(Layout, HasSegmentsThatTouchThemselves) {
    // Two rings around a torus, and one line from the first ring across the second and back to the first.
    // Both segments have the same path as two opposite sides, and each corner vertex twice.
    const QuadMesh mesh = quadMesh(torus(4, 4));
    const Layout layout = layoutAlong(mesh, {{0, 1, 2, 3, 0}, {8, 9, 10, 11, 8}, {1, 5, 9, 13, 1}});
    EXPECT_EQ(layoutFault(mesh, layout), "");
    ASSERT_EQ(layout.segments.size(), 2U);
    for (const Segment& segment : layout.segments) {
        Path side = numbers(segment.sides[segment.size[0] == 4 ? 1 : 0]);
        const Path opposite = numbers(segment.sides[segment.size[0] == 4 ? 3 : 2]);
        std::ranges::reverse(side);
        EXPECT_EQ(side, opposite);
    }
}

TEST(Layout, CountsEveryTrackThatIsNoTransversal) {
    const QuadMesh mesh = rectangle(2, 2);
    const std::vector<Track> tracks{trackAlong(mesh, {1, 4, 7}, 2), trackAlong(mesh, {4, 5}, -0.5)};
    const std::vector<double> flat(mesh.n_edges(), 0);
    const Layout layout = buildLayout(mesh, tracks, flat, flat);
    EXPECT_DOUBLE_EQ(layout.cost, 1.5);
    EXPECT_FALSE(layout.lowerBound);
}

TEST(Layout, OfAMeshWithoutFacesIsEmpty) {
    QuadMesh mesh;
    mesh.add_vertex(Point(0, 0, 0));
    EXPECT_TRUE(layoutAlong(mesh, {}).segments.empty());
}

TEST(Layout, RefusesADeadEnd) {
    EXPECT_EQ(refusal(rectangle(2, 2), {{1, 4}}),
              "vertex 4: a segment has a reflex corner there. The tracks are no motorcycle graph: search "
              "again");
}

TEST(Layout, RefusesABend) {
    EXPECT_NE(refusal(rectangle(2, 2), {{1, 4}, {4, 5}}).find("vertex 4: a segment has a reflex corner"),
              std::string::npos);
}

TEST(Layout, RefusesAReflexBoundaryWithoutATrack) {
    const QuadMesh mesh = quadMesh(plane({"xx", "x."}));
    const std::string said = refusal(mesh, {});
    const VertexId reflex = extraordinaryVertices(mesh).at(0);
    EXPECT_EQ(said.find("vertex " + std::to_string(reflex.idx()) + ": a segment has a reflex corner"), 0U);
}

TEST(Layout, RefusesAnExtraordinaryVertexInside) {
    const QuadMesh cube = quadMesh(polycube(box(1, 1, 1), 2));
    EXPECT_EQ(refusal(cube, {}).find("vertex 0: it is extraordinary and lies inside a segment"), 0U);
    // Without tracks this is one region without a border, but no torus that could be cut open.
    const Cells frame{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}};
    const QuadMesh handle = quadMesh(polycube(frame, 2));
    EXPECT_NE(refusal(handle, {}).find("is extraordinary and lies inside a segment"), std::string::npos);
}

TEST(Layout, RefusesASegmentWithTwoBorders) {
    const QuadMesh mesh = quadMesh(plane({"xxx", "x.x", "xxx"}));
    EXPECT_NE(refusal(mesh, {}).find("the segment there has 2 borders"), std::string::npos);
}

TEST(Layout, RefusesAnEdgeOnTwoTracks) {
    EXPECT_EQ(refusal(rectangle(2, 2), {{1, 4, 7}, {7, 4}}).find("edge 7 4: two tracks run over it"), 0U);
    EXPECT_EQ(refusal(rectangle(2, 2), {{0, 1}}).find("edge 0 1: two tracks run over it, or"), 0U);
}

TEST(LayoutQuality, CountsAndMeasures) {
    const QuadMesh mesh = rectangle(4, 2);
    // A track down the second line, and one from its middle to the right: segments of 1 x 2, 3 x 1 and 3 x 1.
    const Layout layout = layoutAlong(mesh, {{1, 6, 11}, {6, 7, 8, 9}});
    PerEdge angles(mesh, 0.1);
    angles.along({6, 7}, 1.0).along({8, 9}, 0.5).along({3, 8}, 1.5);
    const LayoutQuality quality = measureLayout(mesh, layout, angles, 0.45);
    EXPECT_EQ(quality.segments, 3U);
    EXPECT_EQ(quality.tJoints, 1U);
    EXPECT_DOUBLE_EQ(quality.capturedSharpness, 0.5);
    EXPECT_DOUBLE_EQ(quality.medianAspect, 3);
    EXPECT_DOUBLE_EQ(quality.maxAspect, 3);
    EXPECT_DOUBLE_EQ(measureLayout(mesh, layout, angles, 1.0).capturedSharpness, 0);
    EXPECT_DOUBLE_EQ(measureLayout(mesh, layout, angles, 1.5).capturedSharpness, 1);
}

TEST(LayoutQuality, TakesNoCrossingForATJoint) {
    const QuadMesh mesh = rectangle(2, 2);
    const std::vector<double> flat(mesh.n_edges(), 0);
    const Layout layout = layoutAlong(mesh, {{1, 4, 7}, {3, 4, 5}});
    EXPECT_EQ(measureLayout(mesh, layout, flat, 0.5).tJoints, 0U);
    EXPECT_EQ(measureLayout(mesh, layout, flat, 0.5).segments, 4U);
    EXPECT_DOUBLE_EQ(measureLayout(mesh, layout, flat, 0.5).medianAspect, 1);
}

} // namespace
} // namespace qm::test
