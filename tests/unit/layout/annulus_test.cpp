// Components that no particle enters, and segments that are rings.
#include "layout/layout.h"
#include "support/layout_fault.h"
#include "support/polycube.h"
#include "support/random_graph.h"
#include "support/track_along.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace qm::test {
namespace {

constexpr double sharp = 1, flat = 0, dear = 1, cheap = -1;

// A tube of five quads around and three along: vertices 0 to 4 at one end, 5 to 9 next, and 15 to 19 at the
// other.
class Tube : public ::testing::Test {
protected:
    Layout build(const std::vector<Track>& tracks, const PerEdge& angles, const PerEdge& costs) {
        Layout layout = buildLayout(mesh, tracks, angles, costs);
        EXPECT_EQ(layoutFault(mesh, layout), "");
        return layout;
    }
    const QuadMesh mesh = quadMesh(tube(5, 3));
};

TEST_F(Tube, IsCutAlongItsMostCurvedLine) {
    PerEdge angles(mesh, flat);
    angles.along({7, 12}, sharp);
    const Layout layout = build({}, angles, PerEdge(mesh, 0.5));
    ASSERT_EQ(layout.tracks.size(), 1U);
    EXPECT_EQ(layout.tracks[0].track.halfedges.size(), 3U);
    EXPECT_FALSE(layout.tracks[0].transversal);
    const Path path = pathOf(mesh, layout.tracks[0].track);
    EXPECT_TRUE(path == (Path{2, 7, 12, 17}) || path == (Path{17, 12, 7, 2}));
    EXPECT_DOUBLE_EQ(layout.cost, 1.5);
    ASSERT_EQ(layout.segments.size(), 1U);
    EXPECT_EQ(layout.segments[0].size[0] * layout.segments[0].size[1], 15);
    Path corners = numbers(layout.segments[0].corners);
    std::ranges::sort(corners);
    EXPECT_EQ(corners, (Path{2, 2, 17, 17}));
}

TEST_F(Tube, IsCutAroundWhereThatIsMostCurved) {
    PerEdge angles(mesh, flat), costs(mesh, dear);
    angles.along({8, 9}, sharp);
    costs.along({1, 6}, cheap).along({8, 13, 18}, cheap);
    const Layout layout = build({}, angles, costs);
    ASSERT_EQ(layout.tracks.size(), 3U);
    EXPECT_FALSE(layout.tracks[0].transversal);
    EXPECT_EQ(layout.tracks[0].track.halfedges.size(), 5U);
    EXPECT_DOUBLE_EQ(layout.cost, 5 * dear);
    double transversals = 0;
    for (const LayoutTrack& track : layout.tracks)
        if (track.transversal) transversals += track.track.cost;
    EXPECT_DOUBLE_EQ(transversals, 3 * cheap);
    EXPECT_EQ(layout.segments.size(), 2U);
}

TEST_F(Tube, TiesGoToTheLowestEdgeAndTheLowestVertex) {
    const PerEdge none(mesh, 0);
    const Layout whole = build({}, none, none);
    ASSERT_EQ(whole.tracks.size(), 1U);
    const EdgeId lowest = [&] {
        for (const EdgeId edge : mesh.edges())
            if (!mesh.is_boundary(edge)) return EdgeId(edge);
        return EdgeId();
    }();
    EXPECT_EQ(mesh.edge_handle(whole.tracks[0].track.halfedges[0]), lowest);

    const Layout halves = build({trackAlong(mesh, {7, 8, 9, 5, 6, 7})}, none, none);
    ASSERT_EQ(halves.tracks.size(), 3U);
    for (std::size_t t = 1; t < 3; ++t) {
        const Path path = pathOf(mesh, halves.tracks[t].track);
        EXPECT_TRUE(halves.tracks[t].transversal);
        EXPECT_EQ(path.front() % 5, 0) << "the first vertex of the ring";
    }
}

TEST_F(Tube, RingsBetweenTracksAreSplitWhereItIsCheapest) {
    PerEdge costs(mesh, dear);
    costs.along({3, 8}, cheap).along({6, 11}, cheap).along({14, 19}, cheap);
    const Layout layout =
        build({trackAlong(mesh, {5, 6, 7, 8, 9, 5}, 2), trackAlong(mesh, {10, 14, 13, 12, 11, 10}, 3)},
              PerEdge(mesh, sharp), costs);
    EXPECT_EQ(layout.segments.size(), 3U);
    EXPECT_DOUBLE_EQ(layout.cost, 5);
    std::vector<Path> transversals;
    for (const LayoutTrack& track : layout.tracks)
        if (track.transversal) {
            transversals.push_back(pathOf(mesh, track.track));
            std::ranges::sort(transversals.back());
            EXPECT_DOUBLE_EQ(track.track.cost, cheap);
        }
    std::ranges::sort(transversals);
    EXPECT_EQ(transversals, (std::vector<Path>{{3, 8}, {6, 11}, {14, 19}}));
}

TEST_F(Tube, ATrackAcrossLeavesNoRing) {
    const PerEdge none(mesh, 0);
    const Layout layout = build({trackAlong(mesh, {0, 5, 10, 15})}, none, none);
    EXPECT_EQ(layout.tracks.size(), 1U);
    EXPECT_EQ(layout.segments.size(), 1U);
}

TEST(Torus, IsCutAlongOneLineAndAcross) {
    const QuadMesh mesh = quadMesh(torus(4, 3));
    PerEdge angles(mesh, flat), costs(mesh, dear);
    angles.along({5, 6}, sharp);
    costs.along({2, 6, 10, 2}, cheap);
    const Layout layout = buildLayout(mesh, {}, angles, costs);
    EXPECT_EQ(layoutFault(mesh, layout), "");
    ASSERT_EQ(layout.tracks.size(), 2U);
    EXPECT_EQ(layout.tracks[0].track.halfedges.size(), 4U) << "the line through 5 and 6, all around";
    EXPECT_FALSE(layout.tracks[0].transversal);
    EXPECT_TRUE(layout.tracks[1].transversal);
    EXPECT_EQ(pathOf(mesh, layout.tracks[1].track).front(), 6);
    EXPECT_EQ(pathOf(mesh, layout.tracks[1].track).back(), 6);
    EXPECT_DOUBLE_EQ(layout.tracks[1].track.cost, 3 * cheap);
    EXPECT_DOUBLE_EQ(layout.cost, 4 * dear);
    ASSERT_EQ(layout.segments.size(), 1U);
    for (const VertexId corner : layout.segments[0].corners)
        EXPECT_EQ(corner, VertexId(6));
}

TEST(Torus, ATwistedOneIsCutWhereItsLinesEnd) {
    // A strip of 6 x 2 squares whose upper side is glued to its lower side, shifted by two squares, so that
    // lines across do not close after one turn.
    check::CheckedMesh listed;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 6; ++i)
            listed.points.push_back({static_cast<double>(i), static_cast<double>(j), 0.1 * (6 * j + i)});
    const auto number = [](int i, int j) { return j < 3 ? j * 6 + i % 6 : (i + 2) % 6; };
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 6; ++i)
            listed.quads.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
    const QuadMesh mesh = quadMesh(listed);
    PerEdge angles(mesh, flat);
    angles.along({0, 6}, sharp);
    const Layout layout = buildLayout(mesh, {}, angles, PerEdge(mesh, dear));
    EXPECT_EQ(layoutFault(mesh, layout), "");
    ASSERT_EQ(layout.tracks.size(), 2U);
    EXPECT_EQ(layout.tracks[0].track.halfedges.size(), 9U) << "three times across, then it closes";
    EXPECT_EQ(layout.tracks[1].track.halfedges.size(), 2U) << "from one turn of the line to the next";
    EXPECT_EQ(layout.segments.size(), 1U);
}

TEST(Components, AreCutEachForItself) {
    check::CheckedMesh three;
    for (const check::CheckedMesh& part : {tube(4, 1), torus(3, 3), plane({"xx"})}) {
        const auto offset = static_cast<int>(three.points.size());
        three.points.insert(three.points.end(), part.points.begin(), part.points.end());
        for (auto quad : part.quads) {
            for (int& vertex : quad)
                vertex += offset;
            three.quads.push_back(quad);
        }
    }
    const QuadMesh mesh = quadMesh(three);
    const PerEdge none(mesh, 0);
    const Layout layout = buildLayout(mesh, {}, none, none);
    EXPECT_EQ(layoutFault(mesh, layout), "");
    EXPECT_EQ(layout.segments.size(), 3U);
    // The tube, which has one row of quads and no ring inside, gets one track, the torus two, the rectangle
    // none.
    EXPECT_EQ(layout.tracks.size(), 3U);
}

} // namespace
} // namespace qm::test
