#include "mesh/dihedral.h"
#include "prune/prune_optimum.h"
#include "prune/turned_sides.h"
#include "support/layout_fault.h"
#include "support/random_graph.h"
#include "support/track_along.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace qm::test {
namespace {

constexpr int side = 4; // quads along each side; vertex (i, j) is 5 j + i
constexpr int middle = side / 2;

// Two walls that meet under (2, 2) at an angle, in degrees, and a roof on both of them: row 2 is the roof's
// edge, and turns there. Where it is round, it turns as much at its next vertices.
QuadMesh corner(double between, bool isRound = false) {
    const double half = between * std::numbers::pi / 360;
    std::vector<std::array<double, 3>> points;
    for (int j = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i) {
            const double along = std::abs(i - middle), sign = i < middle ? -1 : 1;
            const double bend = isRound && along == middle ? (std::numbers::pi - 2 * half) : 0;
            const double x = sign * (std::min(along, 1.0) * std::sin(half) +
                                     (along - std::min(along, 1.0)) * std::sin(half - bend));
            const double y = -std::min(along, 1.0) * std::cos(half) -
                             (along - std::min(along, 1.0)) * std::cos(half - bend);
            points.push_back({x, y - std::max(0, j - middle) * 0.4, std::min(0.0, 1.0 * (j - middle))});
        }
    std::vector<std::array<int, 4>> quads;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const int first = (side + 1) * j + i;
            quads.push_back({first, first + 1, first + side + 2, first + side + 1});
        }
    return quadMesh({points, quads});
}

const Path roofEdge{10, 11, 12, 13, 14};
const Path wallEdge{2, 7, 12};

std::vector<Path> pathsAfter(const QuadMesh& mesh, const std::vector<Path>& paths, double maxTurn) {
    const std::vector<double> angles = dihedralAngles(mesh);
    const PerEdge costs(mesh, 1);
    std::vector<Track> tracks;
    for (const Path& path : paths)
        tracks.push_back(trackAlong(mesh, path, 1));
    const PrunedMesh pruned{mesh, {}, angles, costs};
    AddedTracks added(pruned, buildLayout(mesh, tracks, angles, costs), {});
    cutTurnedSides(pruned, maxTurn, added);
    return soundPaths(mesh, added.layout());
}

TEST(TurnedSides, ACornerOfSharpEdgesGetsATrackToTheNextBorder) {
    EXPECT_EQ(pathsAfter(corner(90), {roofEdge, wallEdge}, 35),
              (std::vector<Path>{roofEdge, wallEdge, {12, 17, 22}}));
}

TEST(TurnedSides, ATrackThatEndsBackwardsAtTheCornerGoesOnToo) {
    const Path fromCorner(wallEdge.rbegin(), wallEdge.rend());
    EXPECT_EQ(pathsAfter(corner(90), {roofEdge, fromCorner}, 35),
              (std::vector<Path>{roofEdge, fromCorner, {12, 17, 22}}));
}

TEST(TurnedSides, StopsAtTheFirstBorder) {
    const Path across{15, 16, 17, 18, 19};
    EXPECT_EQ(pathsAfter(corner(90), {roofEdge, across, wallEdge}, 35),
              (std::vector<Path>{roofEdge, across, wallEdge, {12, 17}}));
}

TEST(TurnedSides, ALineThatTurnsLessIsLeftAsItIs) {
    EXPECT_EQ(pathsAfter(corner(150), {roofEdge, wallEdge}, 35).size(), 2U);
    EXPECT_EQ(pathsAfter(corner(90), {roofEdge, wallEdge}, 91).size(), 2U);
    EXPECT_EQ(pathsAfter(corner(90), {roofEdge, wallEdge}, 89).size(), 3U);
}

TEST(TurnedSides, ALineThatTurnsEverywhereIsRound) {
    EXPECT_EQ(pathsAfter(corner(140), {roofEdge, wallEdge}, 35).size(), 3U);
    EXPECT_EQ(pathsAfter(corner(140, true), {roofEdge, wallEdge}, 35).size(), 2U);
}

TEST(TurnedSides, WhatIsNoCornerOfTracksStays) {
    EXPECT_EQ(pathsAfter(corner(90), {roofEdge}, 35).size(), 1U);
    const Path throughout{2, 7, 12, 17, 22};
    EXPECT_EQ(pathsAfter(corner(90), {roofEdge, throughout}, 35).size(), 2U);
    EXPECT_EQ(pathsAfter(corner(90), {{2, 7, 12, 17, 22}, {10, 11, 12}}, 35).size(), 2U);
}

// A flat frame of two rings of quads: vertex 4 k is a corner of the outline, 12 + 4 k and 24 + 4 k are
// inside.
QuadMesh frame(double cornerTurn) {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<int, 4>> quads;
    const double half = cornerTurn * std::numbers::pi / 360;
    for (int ring = 0; ring < 3; ++ring)
        for (int k = 0; k < 12; ++k) {
            // Three edges a side; their inner vertices bulge where the corners turn by less than 90 degrees.
            const int corner = k / 3;
            const double along = k % 3 * 2.0 / 3 - 1,
                         out = 1 + (k % 3 > 0 ? std::tan(std::numbers::pi / 4 - half) * 2 / 3 : 0);
            const double turn = corner * std::numbers::pi / 2, size = 1 - 0.3 * ring;
            points.push_back({size * (std::cos(turn) * along + std::sin(turn) * out),
                              size * (std::sin(turn) * along - std::cos(turn) * out), 0});
        }
    for (int ring = 0; ring < 2; ++ring)
        for (int k = 0; k < 12; ++k) {
            const int next = (k + 1) % 12;
            quads.push_back({12 * ring + k, 12 * ring + next, 12 * ring + 12 + next, 12 * ring + 12 + k});
        }
    return quadMesh({points, quads});
}

TEST(TurnedSides, CornersOfAnOutlineGetTracksToTheNextBorder) {
    const auto pathsIn = [](const QuadMesh& mesh, double maxTurn) {
        const std::vector<double> angles = dihedralAngles(mesh);
        const PerEdge costs(mesh, 1);
        const PrunedMesh pruned{mesh, {}, angles, costs};
        AddedTracks added(pruned, buildLayout(mesh, {}, angles, costs), {});
        cutTurnedOutlines(mesh, maxTurn, added);
        return soundPaths(mesh, added.layout());
    };
    const Path anywhere{1, 13, 25}; // the line that makes an annulus a segment
    EXPECT_EQ(pathsIn(frame(90), 35),
              (std::vector<Path>{anywhere, {0, 12, 24}, {3, 15, 27}, {6, 18, 30}, {9, 21, 33}}));
    EXPECT_EQ(pathsIn(frame(90), 91), std::vector<Path>{anywhere});
    EXPECT_EQ(pathsIn(frame(30), 20), std::vector<Path>{anywhere}) << "a circle of twelve edges";
}

TEST(TurnedSides, PruningKeepsTheTracksUnlessSidesNeedNotBeSmooth) {
    const QuadMesh mesh = corner(90);
    const std::vector<double> angles = dihedralAngles(mesh);
    const PerEdge costs(mesh, 1);
    const std::vector<Track> tracks{trackAlong(mesh, roofEdge, 1), trackAlong(mesh, wallEdge, 1)};
    const Layout layout = buildLayout(mesh, tracks, angles, costs);
    const BaseComplex complex = buildBaseComplex(mesh);
    const auto pruned = [&](const PruneOptions& options) {
        return prune({mesh, complex, angles, costs}, layout, options, 0.45);
    };
    PruneOptions options;
    EXPECT_EQ(pruned(options).addedTracks, 1U);
    EXPECT_EQ(pruned(options).layout.segments.size(), 4U);
    options.maxSharpTurn = 180;
    EXPECT_EQ(pruned(options).addedTracks, 0U) << "as in the paper";
    options = {};
    options.smooth = false;
    EXPECT_EQ(pruned(options).addedTracks, 0U);
}

} // namespace
} // namespace qm::test
