#include "bspline/fitting/knots/border_knots.h"
#include "bspline/fitting/lattice/lattice_lines.h"
#include "bspline/network/smooth_network.h"
#include "mesh/dihedral.h"
#include "support/grid_layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace qm {
namespace {

constexpr int columns = 12;

/// A sheet that is waved along i, and as two patches that share the border j = 1. The second is turned by
/// half, so its u runs against i.
class BorderKnots : public testing::Test {
protected:
    explicit BorderKnots(double height = 0.2)
        : sheet{columns, 2, [height](double i, double j) { return Point(i, j, height * std::sin(1.5 * i)); }},
          mesh(test::makeMesh(sheet)),
          layout(test::makeLayout(sheet, {{0, 0, columns, 1, 0}, {0, 1, columns, 2, 2}})),
          network(buildNetwork(mesh, layout, dihedralAngles(mesh), 3)), plan(layout, network) {
        for (const bool isTurned : {false, true}) {
            ReferenceGrid& grid = grids.emplace_back();
            grid.size = {columns, 1};
            grid.steps = 4;
            for (int v = 0; v <= 4; ++v)
                for (int u = 0; u <= 4 * columns; ++u)
                    grid.points.push_back(isTurned ? sheet.place(columns - u / 4.0, 2 - v / 4.0)
                                                   : sheet.place(u / 4.0, v / 4.0));
        }
        for (const ReferenceGrid& grid : grids) {
            LatticeSource source;
            source.grid = &grid;
            source.isSound.assign(columns, true);
            for (std::size_t side = 0; side < 4; ++side)
                source.isCrease[side].assign(side % 2 == 0 ? columns : 1, false);
            lattices.push_back(
                makeLattice(source, {latticeParameters(columns, 4, {}), latticeParameters(1, 4, {})}));
            limits.emplace_back(grid);
        }
    }

    void insert(double tolerance) {
        insertBorderKnots(lattices, limits, std::vector(lattices.size(), tolerance), plan);
    }

    /// The knots of a patch along the border, as places i of the sheet, ascending.
    [[nodiscard]] std::vector<double> knots(std::size_t patch) const {
        std::vector<double> places = plan.chosen(patch, 0);
        if (patch == 0) return places;
        for (double& place : places)
            place = columns - place;
        return {places.rbegin(), places.rend()};
    }

    test::Grid sheet;
    QuadMesh mesh;
    Layout layout;
    SmoothNetwork network;
    KnotPlan plan;
    std::vector<ReferenceGrid> grids;
    std::vector<FitLattice> lattices;
    std::vector<NormalLimits> limits;
};

class FlatBorderKnots : public BorderKnots {
protected:
    FlatBorderKnots() : BorderKnots(0) {}
};

TEST_F(FlatBorderKnots, AreNotNeeded) {
    insert(1e-6);
    EXPECT_TRUE(knots(0).empty());
    EXPECT_TRUE(knots(1).empty());
}

TEST_F(BorderKnots, AreTheSameOnBothSides) {
    insert(0.01);
    EXPECT_FALSE(knots(0).empty());
    EXPECT_EQ(knots(0), knots(1));
    EXPECT_TRUE(plan.chosen(0, 1).empty()) << "none across the border";
}

TEST_F(BorderKnots, LieAsFarApartAsSingleCubicsReach) {
    insert(0.01);
    LatticeLines lines(lattices[0], limits[0], 0, 0.01);
    std::vector<double> ends = knots(0);
    ends.insert(ends.begin(), 0);
    ends.push_back(columns);
    const std::size_t border = lines.count() - 1;
    for (std::size_t k = 0; k + 1 < ends.size();
         ++k) { // side 2 of the first patch, so from the last to the first
        const int end = static_cast<int>(ends[k]);
        const int begin = static_cast<int>(ends[k + 1]);
        EXPECT_TRUE(lines.fits(border, end, begin)) << begin << ' ' << end;
        EXPECT_TRUE(end == 0 || !lines.fits(border, end - 1, begin)) << begin << ' ' << end;
    }
}

TEST_F(BorderKnots, PreferThoseOfOneSide) {
    insert(0.01);
    const double first = knots(0).back();
    ASSERT_LT(first, columns - 2);
    plan = KnotPlan(layout, network);
    plan.insert(1, 0, columns - (first + 1));
    insert(0.01);
    EXPECT_EQ(knots(0).back(), first + 1);
    EXPECT_EQ(knots(0), knots(1));
}

TEST_F(BorderKnots, AreAsTheyWereIfTheySuffice) {
    insert(0.01);
    const std::vector<double> before = knots(0);
    insert(0.02);
    EXPECT_EQ(knots(0), before);
}

} // namespace
} // namespace qm
