// For any set of arcs, the pruning program must count segments and cost as the layout does, and keep what
// smooth borders need.
#include "base/at.h"
#include "prune/layout_values.h"
#include "support/polycube.h"
#include "support/random_graph.h"
#include "support/track_along.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <vector>

namespace qm::test {
namespace {

struct Pruning {
    Pruning(const check::CheckedMesh& checked, const std::vector<Seed>& seeds)
        : mesh(quadMesh(checked)), complex(buildBaseComplex(mesh, seeds)) {
        std::mt19937 random(1);
        angles.assign(mesh.n_edges(), 0.1);
        for (std::size_t edge = 0; edge < mesh.n_edges(); ++edge)
            costs.push_back(std::uniform_real_distribution<double>(-1, 2)(random));
        grids = gridProgram(pruned(), Layout{}, Smoothness());
    }

    [[nodiscard]] PrunedMesh pruned() const { return {mesh, complex, angles, costs}; }

    QuadMesh mesh;
    BaseComplex complex;
    std::vector<double> angles, costs;
    GridProgram grids;
};

/// Tries sets of arcs; makes a layout of each set that the program allows.
/// \return the number of sets allowed
std::size_t countAsLayoutsDo(const Pruning& pruning) {
    std::mt19937 random(2);
    std::size_t allowed = 0;
    for (int tried = 0; tried < 2000; ++tried) {
        PresentArcs present(pruning.grids.graph.arcs.size());
        for (auto&& arc : present)
            arc = random() % 100 < static_cast<unsigned>(tried) % 101;
        const ColumnValues values = pruning.grids.valuesOf(present);
        if (!pruning.grids.program.allows(values)) continue;
        ++allowed;
        const Layout layout = layoutOf(pruning.pruned(), pruning.grids, values);
        EXPECT_NEAR(pruning.grids.segments(values), static_cast<double>(layout.segments.size()), 1e-9);
        EXPECT_NEAR(pruning.grids.program.cost(values), layout.cost, 1e-9);
        // A component without arcs gets a line, which may run along arcs.
        if (std::ranges::count(present, true) == 0) continue;
        EXPECT_TRUE(valuesOf(pruning.pruned(), pruning.grids, layout) == values);
    }
    return allowed;
}

std::vector<Seed> seedsOf(const check::CheckedMesh& checked, std::size_t count, unsigned number) {
    std::mt19937 random(number);
    return randomSeeds(quadMesh(checked), count, random);
}

TEST(GridProgram, CountsSegmentsOfAPart) {
    const check::CheckedMesh part = polycube(bump());
    EXPECT_GT(countAsLayoutsDo(Pruning(part, {})), 5U);
}

TEST(GridProgram, CountsAnnuliOfATorus) {
    const check::CheckedMesh ring = torus(4, 5);
    for (unsigned number = 0; number < 10; ++number)
        EXPECT_GT(countAsLayoutsDo(Pruning(ring, seedsOf(ring, 3, number))), 1U) << number;
}

TEST(GridProgram, CountsAnnuliOfATube) {
    const check::CheckedMesh ring = tube(5, 4);
    for (unsigned number = 0; number < 10; ++number)
        EXPECT_GT(countAsLayoutsDo(Pruning(ring, seedsOf(ring, 3, number))), 1U) << number;
}

TEST(GridProgram, GivesComponentsWithoutSourcesALine) {
    for (const check::CheckedMesh& ring : {torus(4, 5), tube(5, 4)}) {
        const Pruning pruning(ring, {});
        ASSERT_TRUE(pruning.grids.graph.arcs.empty());
        EXPECT_EQ(countAsLayoutsDo(pruning), 2000U);
        EXPECT_FALSE(pruning.grids.program.allows(ColumnValues(pruning.grids.quarters.size(), 0)));
    }
}

TEST(GridProgram, CompletesWhatASolverLeavesOpen) {
    const check::CheckedMesh ring = torus(4, 5);
    const Pruning pruning(ring, seedsOf(ring, 3, 1));
    const ColumnValues values = pruning.grids.valuesOf(PresentArcs(pruning.grids.graph.arcs.size(), true));
    ColumnValues solved = values;
    for (std::size_t column = pruning.grids.graph.arcs.size(); column < solved.size(); ++column)
        solved[ColumnId(column)] = 0.5;
    EXPECT_TRUE(completed(pruning.grids, solved) == values);
}

TEST(GridProgram, GroupsColumnsByLines) {
    const Pruning pruning(polycube(bump()), {});
    const auto lines = columnsOfLines(pruning.grids.graph);
    ASSERT_EQ(lines.size(), pruning.grids.graph.lines.size());
    for (std::size_t line = 0; line < lines.size(); ++line) {
        EXPECT_EQ(lines[line].size(), at(pruning.grids.graph.lines[LineId(line)].arcCount));
        for (const ColumnId column : lines[line])
            EXPECT_EQ(pruning.grids.graph.arcs[ArcId(column.value())].line, LineId(line));
    }
}

TEST(GridProgram, KeepsATrackWhoseEndWouldLeaveASharpTurn) {
    // Three by two squares, folded at a right angle along the line 1-5-9. Its half 5-9 ends on the line 4-7,
    // which turns at the fold.
    QuadMesh mesh = rectangle(3, 2);
    for (const VertexId vertex : mesh.vertices()) {
        const Point place = mesh.point(vertex);
        if (place[0] > 1) mesh.set_point(vertex, {1, place[1], place[0] - 1});
    }
    const auto seed = [&](int from, int to) {
        return Seed{mesh.find_halfedge(VertexId(from), VertexId(to))};
    };
    const std::vector<Seed> seeds{seed(5, 9), seed(6, 7)};
    const BaseComplex complex = buildBaseComplex(mesh, seeds);
    const PerEdge angles(mesh, 0), costs(mesh, 1);
    const std::vector<Track> tracks{trackAlong(mesh, {4, 5, 6, 7}), trackAlong(mesh, {5, 9})};
    const Layout layout = buildLayout(mesh, tracks, angles, costs);
    const Layout without = buildLayout(mesh, std::span(tracks).first(1), angles, costs);
    const PrunedMesh pruned{mesh, complex, angles, costs};
    const auto mayGo = [&](double maxTurn) {
        const GridProgram grids = gridProgram(pruned, layout, {maxTurn, 0});
        EXPECT_TRUE(grids.program.allows(valuesOf(pruned, grids, layout)));
        return grids.program.allows(valuesOf(pruned, grids, without));
    };
    EXPECT_FALSE(mayGo(89));
    EXPECT_TRUE(mayGo(91));
}

} // namespace
} // namespace qm::test
