#include "mesh/dihedral.h"
#include "prune/prune_optimum.h"
#include "prune/rounded_edges.h"
#include "support/layout_fault.h"
#include "support/polycube.h"
#include "support/random_graph.h"
#include "support/track_along.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm::test {
namespace {

constexpr int side = 4; // quads along each side of a sheet; vertex (i, j) is 5 j + i

double radians(double degrees) {
    return degrees / 180 * std::numbers::pi;
}

// A sheet of quads that is bent about the lines across it, by so many degrees each.
QuadMesh sheet(const std::vector<double>& bends, double width = 1) {
    std::vector<std::array<double, 2>> section{{0, 0}};
    double direction = 0;
    for (int i = 0; i < side; ++i) {
        if (i > 0) direction += radians(bends[std::size_t(i - 1)]);
        const auto [x, z] = section.back();
        section.push_back({x + width * std::cos(direction), z + width * std::sin(direction)});
    }
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<int, 4>> quads;
    for (int j = 0; j <= side; ++j)
        for (const auto& [x, z] : section)
            points.push_back({x, 1.0 * j, z});
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const int first = (side + 1) * j + i;
            quads.push_back({first, first + 1, first + side + 2, first + side + 1});
        }
    return quadMesh({points, quads});
}

std::vector<Path> pathsAfter(const QuadMesh& mesh, const std::vector<Path>& paths,
                             const std::vector<EdgeId>& forbidden = {}) {
    const std::vector<double> angles = dihedralAngles(mesh);
    const PerEdge costs(mesh, 1);
    std::vector<Track> tracks;
    for (const Path& path : paths)
        tracks.push_back(trackAlong(mesh, path, 1));
    const BaseComplex none;
    const PrunedMesh pruned{mesh, none, angles, costs};
    AddedTracks added(pruned, buildLayout(mesh, tracks, angles, costs), forbidden);
    cutAlongRoundedEdges(pruned, added);
    return soundPaths(mesh, added.layout());
}

const Path fold{2, 7, 12, 17, 22};

TEST(RoundedEdges, AFoldInsideASegmentBecomesABoundary) {
    EXPECT_EQ(pathsAfter(sheet({0, 90, 0}), {}), std::vector<Path>{fold});
    EXPECT_EQ(pathsAfter(sheet({0, 45, 0}), {}), std::vector<Path>{fold});
    EXPECT_EQ(pathsAfter(sheet({0, 38, 0}), {}).size(), 0U) << "below the angle of chamfers";
}

TEST(RoundedEdges, TheTracksReachFromBoundaryToBoundary) {
    const Path across{10, 11, 12, 13, 14};
    EXPECT_EQ(pathsAfter(sheet({0, 90, 0}), {across}), (std::vector<Path>{across, {2, 7, 12}, {12, 17, 22}}));
    const Path along{2, 7, 12};
    EXPECT_EQ(pathsAfter(sheet({0, 90, 0}), {across, along}),
              (std::vector<Path>{across, along, {12, 17, 22}}));
}

TEST(RoundedEdges, WhatIsBentEverywhereIsRound) {
    const auto divides = [](double bend) {
        const std::vector<Path> paths = pathsAfter(sheet({bend, bend, bend}), {});
        return std::ranges::find(paths, fold) != paths.end();
    };
    EXPECT_FALSE(divides(45));
    EXPECT_TRUE(divides(75)) << "too sharp for a round part";
}

TEST(RoundedEdges, WhereRoundingIsSmallAFoldStays) {
    // The diagonal is about 4, and quads of width w are rounded by w / 10 at 45 degrees, and w / 5 at 90.
    EXPECT_EQ(pathsAfter(sheet({0, 45, 0}, .15), {}).size(), 1U);
    EXPECT_EQ(pathsAfter(sheet({0, 45, 0}, .1), {}).size(), 0U);
    EXPECT_EQ(pathsAfter(sheet({0, 90, 0}, .03), {}).size(), 1U);
    EXPECT_EQ(pathsAfter(sheet({0, 90, 0}, .015), {}).size(), 0U);
}

TEST(RoundedEdges, NoTrackGoesOverForbiddenEdges) {
    const QuadMesh mesh = sheet({0, 90, 0});
    const Track track = trackAlong(mesh, fold, 1);
    EXPECT_EQ(pathsAfter(mesh, {}, {mesh.edge_handle(track.halfedges[1])}).size(), 0U);
}

TEST(RoundedEdges, ATrackMayGoAroundAnAnnulus) {
    // A block whose four sides are one annulus: its upright edges are sharp, and one of its rings shall be a
    // track.
    const QuadMesh mesh = quadMesh(polycube(box(1, 1, 2)));
    const PerEdge values(mesh, 0);
    const auto at = [&](double x, double y, double z) {
        for (const VertexId vertex : mesh.vertices())
            if (mesh.point(vertex) == Point(x, y, z)) return vertex.idx();
        return -1;
    };
    const auto ring = [&](double z) {
        return Path{at(0, 0, z), at(1, 0, z), at(1, 1, z), at(0, 1, z), at(0, 0, z)};
    };
    std::vector<Track> tracks;
    for (const double z : {0., 2.})
        for (std::size_t k = 0; k < 4; ++k)
            tracks.push_back(trackAlong(mesh, {ring(z)[k], ring(z)[k + 1]}));
    const BaseComplex none;
    const PrunedMesh pruned{mesh, none, values, values};
    AddedTracks added(pruned, buildLayout(mesh, tracks, values, values), {});
    added.addThrough(trackAlong(mesh, ring(1)).halfedges.front());
    EXPECT_EQ(added.count(), 1U);
    const Layout layout = added.layout();
    EXPECT_EQ(layoutFault(mesh, layout), "");
    EXPECT_EQ(layout.segments.size(), 4U);
    EXPECT_EQ(pathOf(mesh, properTracks(layout).back()).size(), 5U);
}

TEST(RoundedEdges, PruningAddsTracksUnlessTheUserSaysOtherwise) {
    const QuadMesh mesh = sheet({0, 90, 0});
    const std::vector<double> angles = dihedralAngles(mesh);
    const PerEdge costs(mesh, 1);
    const Layout layout = buildLayout(mesh, {}, angles, costs);
    const BaseComplex complex = buildBaseComplex(mesh);
    const auto addedBy = [&](const PruneOptions& options) {
        const PruneResult result = prune({mesh, complex, angles, costs}, layout, options, 0.45);
        EXPECT_EQ(result.layout.segments.size(), 1 + result.addedTracks);
        return result.addedTracks;
    };
    const PruneOptions usual;
    EXPECT_EQ(addedBy(usual), 1U);
    PruneOptions options = usual;
    options.method = PruneMethod::optimum;
    EXPECT_EQ(addedBy(options), 1U);
    options.fewestPatches = true;
    EXPECT_EQ(addedBy(options), 0U);
    options.fewestPatches = false;
    options.maxSegments = 1;
    EXPECT_EQ(addedBy(options), 0U);
    options = usual;
    options.maxSharpTurn = 180;
    EXPECT_EQ(addedBy(options), 0U) << "as in the paper";
    options = usual;
    options.smooth = false;
    EXPECT_EQ(addedBy(options), 0U);
}

TEST(RoundedEdges, ATorusStaysOneSegment) {
    const QuadMesh mesh = quadMesh(torus(4, 4));
    std::vector<double> angles(mesh.n_edges(), 1.5);
    const PerEdge costs(mesh, 1);
    const BaseComplex none;
    const PrunedMesh pruned{mesh, none, angles, costs};
    AddedTracks added(pruned, buildLayout(mesh, {}, angles, costs), {});
    cutAlongRoundedEdges(pruned, added);
    EXPECT_EQ(added.count(), 0U);
}

} // namespace
} // namespace qm::test
