#include "base/at.h"
#include "bspline/reference/scan/scan_folds.h"
#include "shape/shape.h"
#include "support/limit_sample.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace qm {
namespace {

/// A torus with targets, which are at first its own points.
struct Targets {
    QuadMesh mesh = makeShape("torus", {.resolution = 2});
    Layout layout = test::segmentPerQuad(mesh);
    std::vector<ReferenceGrid> surface =
        test::limitSurface(mesh, layout, std::vector<bool>(mesh.n_edges()), 4, 1);
    LatticeNormals lattice = latticeNormals(mesh, layout, surface, 1);
    FitTarget reference{surface, {}};

    Targets() {
        for (const ReferenceGrid& grid : surface)
            reference.weights.emplace_back(grid.points.size(), 1.0);
    }
    [[nodiscard]] std::size_t dropped() const {
        std::size_t count = 0;
        for (const std::vector<double>& weights : reference.weights)
            count += at(std::ranges::count(weights, 0.0));
        return count;
    }
};

TEST(ScanFolds, NothingIsDroppedWhereNothingFolds) {
    Targets targets;
    for (std::size_t g = 0; g < targets.surface.size(); ++g)
        for (Point& point : targets.reference.grids[g].points)
            point *= 1.1;
    const FitTarget before = targets.reference;
    dropFolded(targets.lattice, targets.surface, targets.reference);
    EXPECT_EQ(targets.dropped(), 0);
    EXPECT_EQ(targets.reference.grids.front().points, before.grids.front().points);
}

TEST(ScanFolds, TargetsThatPassTheirNeighboursGoBackToTheSurface) {
    Targets targets;
    constexpr std::size_t middle = 12; // of 5 x 5 points
    std::vector<Point>& points = targets.reference.grids[0].points;
    points[middle] = points[middle + 2] + (points[middle + 2] - points[middle + 1]);
    dropFolded(targets.lattice, targets.surface, targets.reference);
    EXPECT_EQ(points, targets.surface[0].points);
    EXPECT_EQ(targets.reference.weights[0][middle], 0);
    EXPECT_EQ(targets.reference.weights[0][0], 1);
    // The cells before the moved target are stretched, those behind it are turned over.
    EXPECT_EQ(targets.dropped(), 6);
}

TEST(ScanFolds, PointsOnBordersGoBackOnBothSides) {
    Targets targets;
    // Moves a corner of the segment far along its first border.
    const std::size_t corner = targets.lattice.numbers[0][0];
    const Point moved = targets.surface[0].points[3];
    std::size_t copies = 0;
    for (std::size_t g = 0; g < targets.surface.size(); ++g)
        for (std::size_t k = 0; k < targets.surface[g].points.size(); ++k)
            if (targets.lattice.numbers[g][k] == corner) {
                targets.reference.grids[g].points[k] = moved;
                ++copies;
            }
    EXPECT_EQ(copies, 4);
    dropFolded(targets.lattice, targets.surface, targets.reference);
    for (std::size_t g = 0; g < targets.surface.size(); ++g)
        for (std::size_t k = 0; k < targets.surface[g].points.size(); ++k)
            if (targets.lattice.numbers[g][k] == corner) {
                EXPECT_EQ(targets.reference.weights[g][k], 0);
                EXPECT_EQ(targets.reference.grids[g].points[k], targets.surface[g].points[k]);
            }
}

} // namespace
} // namespace qm
