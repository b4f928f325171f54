#include "base/at.h"
#include "base/disjoint_sets.h"
#include "mesh/triangles/repair_triangles.h"
#include "mesh/triangles/triangle_edges.h"
#include "support/message_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace qm {
namespace {

/// The surface of a union of unit cubes, with shared points.
Triangles voxelSurface(const std::set<std::array<int, 3>>& cubes) {
    Triangles surface;
    std::map<std::array<int, 3>, int> numbers;
    const auto number = [&](const std::array<int, 3>& point) {
        const auto [entry, isNew] = numbers.try_emplace(point, static_cast<int>(numbers.size()));
        if (isNew) surface.points.emplace_back(point[0], point[1], point[2]);
        return entry->second;
    };
    for (const auto& cube : cubes)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                std::array<int, 3> neighbour = cube;
                neighbour[axis] += step;
                if (cubes.contains(neighbour)) continue;
                std::array<int, 4> corners{};
                for (std::size_t k = 0; k < 4; ++k) {
                    std::array<int, 3> point = cube;
                    point[axis] += step > 0 ? 1 : 0;
                    point[(axis + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
                    point[(axis + 2) % 3] += k >= 2 ? 1 : 0;
                    corners[k] = number(point);
                }
                if (step < 0) std::ranges::reverse(corners);
                surface.faces.push_back({corners[0], corners[1], corners[2]});
                surface.faces.push_back({corners[0], corners[2], corners[3]});
            }
    return surface;
}

double volume(const Triangles& surface) {
    double sum = 0;
    for (const auto& [a, b, c] : surface.faces)
        sum += surface.points[at(a)] | (surface.points[at(b)] % surface.points[at(c)]);
    return sum / 6;
}

/// Two triangles at every edge, in opposite directions, and one sheet at every point.
void expectClosed(const Triangles& surface) {
    std::map<int, std::map<int, int>> links; // of every point: from neighbour to neighbour around it
    forEachEdge(surface, [&](std::span<const TriangleSide> edge) {
        ASSERT_EQ(edge.size(), 2U);
        EXPECT_NE(edge[0].ascends, edge[1].ascends);
    });
    for (const auto& face : surface.faces)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_TRUE(links[face[k]].emplace(face[(k + 1) % 3], face[(k + 2) % 3]).second);
    for (const auto& [point, link] : links) {
        std::size_t steps = 0;
        int at = link.begin()->first;
        do {
            at = link.at(at);
            ++steps;
        } while (at != link.begin()->first && steps <= link.size());
        EXPECT_EQ(steps, link.size()) << "around point " << point;
    }
}

std::size_t componentCount(const Triangles& surface) {
    DisjointSets sets(surface.points.size());
    for (const auto& [a, b, c] : surface.faces) {
        sets.join(at(a), at(b));
        sets.join(at(b), at(c));
    }
    std::set<std::size_t> components;
    for (const auto& face : surface.faces)
        components.insert(sets.find(at(face[0])));
    return components.size();
}

TEST(RepairTriangles, LeavesAManifoldAlone) {
    Triangles cube = voxelSurface({{0, 0, 0}});
    const Triangles before = cube;
    EXPECT_EQ(repairTriangles(cube), TriangleRepair{});
    EXPECT_EQ(cube.faces, before.faces);
    EXPECT_EQ(cube.points, before.points);
}

TEST(RepairTriangles, TurnsTheMinority) {
    Triangles cube = voxelSurface({{0, 0, 0}});
    std::swap(cube.faces[3][0], cube.faces[3][2]);
    std::swap(cube.faces[8][0], cube.faces[8][1]);
    EXPECT_EQ(repairTriangles(cube).turnedTriangles, 2U);
    expectClosed(cube);
    EXPECT_NEAR(volume(cube), 1, 1e-12);
}

TEST(RepairTriangles, DropsDoubledTriangles) {
    Triangles cube = voxelSurface({{0, 0, 0}});
    const std::size_t count = cube.faces.size();
    cube.faces.push_back(cube.faces[2]);
    cube.faces.push_back({cube.faces[5][1], cube.faces[5][2], cube.faces[5][0]});
    EXPECT_EQ(repairTriangles(cube).doubledTriangles, 2U);
    EXPECT_EQ(cube.faces.size(), count);
    expectClosed(cube);
}

TEST(RepairTriangles, DropsFlapsOnAWholeSurface) {
    Triangles cube = voxelSurface({{0, 0, 0}});
    const std::size_t count = cube.faces.size();
    const int tip = static_cast<int>(cube.points.size());
    cube.points.emplace_back(0.5, 0.5, 3);
    cube.points.emplace_back(0.5, 0.5, 4);
    const int a = cube.faces[0][0], b = cube.faces[0][1];
    for (const std::array<int, 3>& flap :
         {std::array{a, b, tip}, std::array{b, a, tip},              // one at an edge of the cube
          std::array{b, tip, tip + 1}, std::array{tip, b, tip + 1}}) // and one on it
        cube.faces.push_back(flap);
    EXPECT_EQ(repairTriangles(cube).doubledTriangles, 4U);
    EXPECT_EQ(cube.faces.size(), count);
    expectClosed(cube);
}

TEST(RepairTriangles, KeepsOneSideOfATwoSidedSheet) {
    Triangles sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                    {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}}};
    EXPECT_EQ(repairTriangles(sheet).doubledTriangles, 2U);
    EXPECT_EQ(sheet.faces.size(), 2U);
    EXPECT_EQ(boundaryLoopCount(sheet), 1U);
}

TEST(RepairTriangles, TakesSolidsApartThatTouch) {
    Triangles cubes = voxelSurface({{0, 0, 0}, {1, 1, 0}}); // along an edge
    const TriangleRepair report = repairTriangles(cubes);
    EXPECT_EQ(report.crowdedEdges, 1U);
    EXPECT_EQ(report.touchingPoints, 2U);
    expectClosed(cubes);
    EXPECT_EQ(componentCount(cubes), 2U);
    EXPECT_NEAR(volume(cubes), 2, 1e-12);

    cubes = voxelSurface({{0, 0, 0}, {1, 1, 1}}); // in a corner
    EXPECT_EQ(repairTriangles(cubes).touchingPoints, 1U);
    expectClosed(cubes);
    EXPECT_EQ(componentCount(cubes), 2U);
}

TEST(RepairTriangles, DividesEdgesWhoseEndsCannotBeSplit) {
    std::set<std::array<int, 3>> cubes; // a block of 2 x 2 x 3 without two opposite cubes in the middle
    for (int k = 0; k < 12; ++k)
        cubes.insert({k % 2, k / 2 % 2, k / 4});
    cubes.erase({0, 1, 1});
    cubes.erase({1, 0, 1});
    Triangles block = voxelSurface(cubes);
    const std::size_t count = block.faces.size();
    EXPECT_EQ(repairTriangles(block).crowdedEdges, 1U);
    EXPECT_EQ(block.faces.size(), count + 2);
    expectClosed(block);
    EXPECT_NEAR(volume(block), 10, 1e-12);
}

TEST(RepairTriangles, SeparatesAnInnerWallWhereTheSurfaceIsFlattest) {
    Triangles fin{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.1}, {0.5, 0.5, 1}},
                  {{0, 1, 2}, {0, 2, 3}, {0, 2, 4}}};
    const TriangleRepair report = repairTriangles(fin);
    EXPECT_EQ(report.crowdedEdges, 1U);
    EXPECT_EQ(componentCount(fin), 2U);
    EXPECT_EQ(boundaryLoopCount(fin), 2U);
    EXPECT_EQ(fin.faces[1][0], fin.faces[0][0]) << "the flat pair stays together";
}

TEST(RepairTriangles, ManyRandomSolidsBecomeManifolds) {
    unsigned state = 1;
    const auto chance = [&] { return (state = state * 1664525U + 1013904223U) >> 24U; };
    for (int round = 0; round < 60; ++round) {
        std::set<std::array<int, 3>> cubes;
        for (int k = 0; k < 64; ++k)
            if (chance() < 128) cubes.insert({k % 4, k / 4 % 4, k / 16});
        Triangles surface = voxelSurface(cubes);
        repairTriangles(surface);
        expectClosed(surface);
        EXPECT_NEAR(volume(surface), static_cast<double>(cubes.size()), 1e-9);
    }
}

TEST(RepairTriangles, AMoebiusStripIsRefusedWithThePlace) {
    Triangles strip;
    for (int k = 0; k < 8; ++k)
        strip.points.emplace_back(k / 2, k % 2, 0);
    for (int k = 0; k < 6; ++k)
        strip.faces.push_back({k, k + 1, k + 2});
    strip.faces.push_back({6, 7, 1}); // ends exchanged
    strip.faces.push_back({7, 1, 0});
    const std::string message = test::messageOf([&] { repairTriangles(strip); });
    EXPECT_NE(message.find("at ("), std::string::npos);
    EXPECT_NE(message.find("one side only"), std::string::npos);
}

TEST(RepairTriangles, TrianglesWithoutAreaDoNoHarm) {
    Triangles spikes{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {}};
    for (const int tip : {2, 3, 4, 5, 2})
        spikes.faces.push_back({0, 1, tip});
    spikes.faces.push_back({1, 0, 3});
    repairTriangles(spikes);
    forEachEdge(spikes, [](std::span<const TriangleSide> edge) { EXPECT_LE(edge.size(), 2U); });
}

} // namespace
} // namespace qm
