#include "enumerate/paper/plain_graph.h"
#include "support/polycube.h"
#include "support/random_graph.h"
#include "support/track_along.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace qm::test {
namespace {

// Squares of the plane with seven columns and seven rows of vertices; these tests number vertex (x, y) as 10
// y + x.
class PlainGraph : public ::testing::Test {
protected:
    static int vertex(int number) { return number / 10 * 7 + number % 10; }

    /// \param seeds  for each, its vertex and the next one in the direction of its first particle
    std::vector<Path> race(const std::vector<std::array<int, 2>>& seeds) {
        std::vector<Seed> given;
        given.reserve(seeds.size());
        for (const auto& [from, to] : seeds)
            given.push_back({mesh.find_halfedge(VertexId(vertex(from)), VertexId(vertex(to)))});
        const std::vector<double> costs(mesh.n_edges(), 0.5);
        const MotorcycleGraph graph = plainMotorcycleGraph(mesh, buildBaseComplex(mesh, given), costs);
        std::vector<Path> paths;
        double edges = 0;
        for (const Track& track : graph.tracks) {
            paths.push_back(pathOf(mesh, track));
            for (int& number : paths.back())
                number = number / 7 * 10 + number % 7;
            EXPECT_DOUBLE_EQ(track.cost, 0.5 * static_cast<double>(track.halfedges.size()));
            edges += static_cast<double>(track.halfedges.size());
        }
        EXPECT_DOUBLE_EQ(graph.cost, 0.5 * edges);
        return paths;
    }

    static bool contains(const std::vector<Path>& paths, const Path& path) {
        return std::ranges::find(paths, path) != paths.end();
    }

    const QuadMesh mesh = rectangle(6, 6);
};

TEST_F(PlainGraph, GoesOnToTheBoundary) {
    const std::vector<Path> paths = race({{33, 34}});
    EXPECT_EQ(paths.size(), 2U);
    EXPECT_TRUE(contains(paths, {33, 34, 35, 36}));
    EXPECT_TRUE(contains(paths, {33, 32, 31, 30}));
}

TEST_F(PlainGraph, StopsWhereSomebodyHasBeen) {
    const std::vector<Path> paths = race({{31, 32}, {23, 33}});
    EXPECT_TRUE(contains(paths, {31, 32, 33}));
    EXPECT_TRUE(contains(paths, {23, 33, 43, 53, 63}));
}

TEST_F(PlainGraph, StopsAtASeed) {
    const std::vector<Path> paths = race({{31, 32}, {33, 43}});
    EXPECT_TRUE(contains(paths, {31, 32, 33}));
}

TEST_F(PlainGraph, AtARightAngleTheClockwiseOneStops) {
    // One particle comes from the left and one from below; the angle between their last edges leads
    // counter-clockwise from the left one to the lower one.
    const std::vector<Path> left = race({{31, 32}, {13, 23}});
    EXPECT_TRUE(contains(left, {31, 32, 33}));
    EXPECT_TRUE(contains(left, {13, 23, 33, 43, 53, 63}));
    const std::vector<Path> right = race({{35, 34}, {13, 23}});
    EXPECT_TRUE(contains(right, {35, 34, 33, 32, 31, 30}));
    EXPECT_TRUE(contains(right, {13, 23, 33}));
}

TEST_F(PlainGraph, HeadOnBothStop) {
    const std::vector<Path> crossed = race({{31, 32}, {35, 34}, {13, 23}, {53, 43}});
    EXPECT_EQ(crossed.size(), 8U) << "all four of the inner ones meet at once";
    for (const Path& path : {Path{31, 32, 33}, Path{35, 34, 33}, Path{13, 23, 33}, Path{53, 43, 33}})
        EXPECT_TRUE(contains(crossed, path));
    // The particle from below arrives later.
    const std::vector<Path> later = race({{41, 42}, {45, 44}, {13, 23}});
    for (const Path& path : {Path{41, 42, 43}, Path{45, 44, 43}, Path{13, 23, 33, 43}})
        EXPECT_TRUE(contains(later, path));
}

TEST_F(PlainGraph, OfThreeAtOnceAllStop) {
    const std::vector<Path> paths = race({{31, 32}, {35, 34}, {13, 23}});
    for (const Path& path : {Path{31, 32, 33}, Path{35, 34, 33}, Path{13, 23, 33}})
        EXPECT_TRUE(contains(paths, path));
}

TEST_F(PlainGraph, HeadOnWhereNothingCrossesTheLowerOneTakesTheRest) {
    const std::vector<Path> vertexMeeting = race({{31, 32}, {35, 34}});
    EXPECT_TRUE(contains(vertexMeeting, {31, 32, 33, 34, 35}));
    EXPECT_EQ(vertexMeeting.size(), 3U);
    const std::vector<Path> edgeMeeting = race({{31, 32}, {34, 33}});
    EXPECT_TRUE(contains(edgeMeeting, {31, 32, 33, 34}));
    EXPECT_EQ(edgeMeeting.size(), 3U);
    // The track is extended no farther than to the next crossing, as a particle from below has stopped at 34.
    const std::vector<Path> crossing = race({{31, 32}, {35, 34}, {24, 34}});
    for (const Path& path : {Path{31, 32, 33, 34}, Path{35, 34}, Path{24, 34}})
        EXPECT_TRUE(contains(crossing, path));
}

TEST_F(PlainGraph, OnAnEdgeBetweenTwoSourcesTheLowerOneMoves) {
    const QuadMesh cube = quadMesh(polycube(box(1, 1, 1)));
    const std::vector<double> costs(cube.n_edges(), 1);
    const MotorcycleGraph graph = plainMotorcycleGraph(cube, buildBaseComplex(cube), costs);
    ASSERT_EQ(graph.tracks.size(), 12U);
    for (const Track& track : graph.tracks) {
        const Path path = pathOf(cube, track);
        ASSERT_EQ(path.size(), 2U);
        EXPECT_LT(path[0], path[1]);
    }
    EXPECT_DOUBLE_EQ(graph.cost, 12);
}

} // namespace
} // namespace qm::test
