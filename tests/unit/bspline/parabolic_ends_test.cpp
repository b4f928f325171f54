#include "bspline/reference/limit/parabolic_ends.h"
#include "bspline/splines/evaluate.h"
#include "support/grid_layout.h"
#include "support/limit_sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace qm {
namespace {

/// 12 degrees of a cylinder around z an edge, from the x axis on.
test::Grid arcs(int edges) {
    return {edges, 4, [](double i, double j) {
                const double angle = 12 * i * std::numbers::pi / 180;
                return Point(std::cos(angle), std::sin(angle), 0.2 * j);
            }};
}

/// The limit surface of a grid that is open all around, and how its lines end.
struct OpenGrid {
    test::Grid grid;
    test::LimitSample sample;
    std::vector<Turn> turns;

    explicit OpenGrid(const test::Grid& given)
        : grid(given), sample(test::makeMesh(given)), turns(parabolicEnds(sample.limit, sample.sharpness())) {
    }

    [[nodiscard]] VertexId vertex(int i, int j) const { return VertexId(j * (grid.columns + 1) + i); }
    /// Of the cylinder.
    [[nodiscard]] Point normal(int i, int j) const {
        return sample.mesh.point(vertex(i, j)) - Point(0, 0, 0.2 * j);
    }
    [[nodiscard]] Point edge(int i, int j) const {
        return sample.mesh.point(vertex(i + 1, j)) - sample.mesh.point(vertex(i, j));
    }
    /// At vertex (i, j), towards another one; as it is, and turned.
    [[nodiscard]] Point derivative(VertexId from, VertexId to) const {
        return sample.limit.derivative(sample.mesh.find_halfedge(from, to));
    }
    [[nodiscard]] Point turned(VertexId from, VertexId to) const {
        Point sum = derivative(from, to);
        for (const Turn& turn : turns)
            if (turn.leaving == sample.mesh.find_halfedge(from, to)) sum += turn.by;
        return sum;
    }
    /// Along the line j at its vertex i, against the line at its last one.
    [[nodiscard]] Point turnedAt(int i, int j) const {
        return i < grid.columns ? turned(vertex(i, j), vertex(i + 1, j))
                                : -turned(vertex(i, j), vertex(i - 1, j));
    }
};

TEST(ParabolicEnds, AreTangentToArcs) {
    const OpenGrid open(arcs(6));
    for (int j = 0; j <= 4; ++j) { // the outermost lines are creases that end at corners
        const VertexId from = open.vertex(0, j);
        const VertexId to = open.vertex(1, j);
        EXPECT_GT(std::abs(unit(open.derivative(from, to))[0]), 0.05) << "three degrees without";
        EXPECT_LT(std::abs(unit(open.turned(from, to))[0]), 0.005) << j;
    }
}

TEST(ParabolicEnds, LeaveTheOtherVerticesSmooth) {
    const OpenGrid open(arcs(6));
    for (int j = 0; j <= 4; ++j)
        for (int i = 1; i < 6; ++i) {
            const Point ahead = open.turned(open.vertex(i, j), open.vertex(i + 1, j));
            const Point back = open.turned(open.vertex(i, j), open.vertex(i - 1, j));
            EXPECT_LT((ahead + back).norm(), 1e-10) << i << ' ' << j;
            const Point jump = open.turnedAt(i - 1, j) + 4 * ahead + open.turnedAt(i + 1, j) -
                               3 * (open.edge(i - 1, j) + open.edge(i, j));
            EXPECT_LT(std::abs(jump | open.normal(i, j)), 2e-3 * open.edge(i, j).norm())
                << "of second derivatives";
        }
}

TEST(ParabolicEnds, OfTwoEdgesMakeOneParabola) {
    const OpenGrid open(arcs(2));
    for (int j = 0; j <= 4; ++j)
        for (int i = 0; i < 2; ++i) {
            const Point third = open.turnedAt(i, j) + open.turnedAt(i + 1, j) - 2 * open.edge(i, j);
            EXPECT_LT(std::abs(third | open.normal(1, j)), 3e-3 * open.edge(i, j).norm()) << "0.05 without";
        }
}

TEST(ParabolicEnds, LeaveStraightLinesAndSingleEdgesAlone) {
    for (const OpenGrid& open :
         {OpenGrid({6, 4, [](double i, double j) { return Point(i, j, 0.3 * i); }}), OpenGrid(arcs(1))})
        for (const Turn& turn : open.turns)
            EXPECT_LT(turn.by.norm(), 1e-10);
}

} // namespace
} // namespace qm
