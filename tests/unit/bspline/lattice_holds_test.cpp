#include "bspline/fitting/lattice/lattice_holds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace qm {
namespace {

/// A lattice over 5 x 3 quads, denser along u in the middle; all targets have slid by (1, 0, 0).
FitLattice slidLattice() {
    FitLattice lattice;
    lattice.targets.parameters = {std::vector<double>{0, 0.5, 1, 1.5, 2, 2.125, 2.25, 2.5, 3, 4, 5},
                                  std::vector<double>{0, 1, 1.5, 2, 3}};
    for (std::size_t k = 0; k < lattice.columns() * lattice.rows(); ++k) {
        const auto [u, v] = lattice.parametersAt(k);
        lattice.reference.emplace_back(u, v, 0);
        lattice.targets.points.emplace_back(u + 1, v, 0);
    }
    lattice.slides.assign(lattice.reference.size(), Point(1, 0, 0));
    lattice.isHeld.assign(lattice.reference.size(), false);
    lattice.holds.assign(lattice.reference.size(), 0);
    return lattice;
}

TEST(LatticeHolds, AreWithinAnEdgeOfFoldsAndCountThem) {
    FitLattice lattice = slidLattice();
    std::vector<bool> isFolded(lattice.reference.size());
    for (const std::size_t point : {4U, 6U, 30U, 54U})
        isFolded[point] = true;
    holdAroundFolds(isFolded, lattice);
    for (std::size_t k = 0; k < lattice.reference.size(); ++k) {
        int near = 0;
        for (std::size_t fold = 0; fold < isFolded.size(); ++fold) {
            const auto [u, v] = lattice.parametersAt(k);
            const auto [foldU, foldV] = lattice.parametersAt(fold);
            if (isFolded[fold] && std::abs(u - foldU) <= 1 && std::abs(v - foldV) <= 1) ++near;
        }
        EXPECT_EQ(lattice.isHeld[k], near > 0) << k;
        EXPECT_EQ(static_cast<int>(lattice.holds[k]), std::min(near, maxHolds)) << k;
        EXPECT_EQ(lattice.slides[k][0], near > 0 ? 0 : 1) << k;
        EXPECT_EQ(lattice.targets.points[k][0] - lattice.reference[k][0], near > 0 ? 0 : 1) << k;
    }
    releaseHolds(lattice);
    for (std::size_t k = 0; k < lattice.reference.size(); ++k)
        EXPECT_EQ(lattice.isHeld[k], lattice.holds[k] == maxHolds) << k;
}

TEST(LatticeHolds, AreForGoodWhereTargetsAreHeld) {
    FitLattice lattice = slidLattice();
    EXPECT_TRUE(holdTargets({{{0.6, 0.5}, {2, 1.5}}}, lattice));
    EXPECT_FALSE(holdTargets({{{1, 1}, {1.5, 1.2}}}, lattice));
    releaseHolds(lattice);
    EXPECT_EQ(std::ranges::count(lattice.isHeld, true), 3 * 2);
    EXPECT_FALSE(lattice.isHeld[lattice.columns() + 1]);
    EXPECT_TRUE(lattice.isHeld[lattice.columns() + 2]);
}

} // namespace
} // namespace qm
