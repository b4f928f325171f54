#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/lattice_errors.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace qm {
namespace {

/// A lattice over one plane quad, and a patch above it.
class LatticeErrors : public testing::Test {
protected:
    LatticeErrors() {
        grid.size = {1, 1};
        for (const double v : {0.0, 0.5, 1.0})
            for (const double u : {0.0, 0.5, 1.0})
                grid.points.emplace_back(u, v, 0);
        source.grid = &grid;
        for (auto& side : source.isCrease)
            side = {false};
        source.isSound = {true};
        lattice = makeLattice(source, {std::vector<double>{0, 0.5, 1}, std::vector<double>{0, 0.5, 1}});
    }

    static Patch lifted(double height) {
        Patch patch;
        patch.degree = {1, 1};
        patch.count = {2, 2};
        patch.knots = {std::vector<double>{0, 0, 1, 1}, std::vector<double>{0, 0, 1, 1}};
        for (const double v : {0.0, 1.0})
            for (const double u : {0.0, 1.0})
                patch.controlPoints.emplace_back(u, v, height);
        return patch;
    }

    static Patch raisedInTheMiddle(double height) {
        Patch patch;
        patch.degree = {1, 1};
        patch.count = {3, 3};
        patch.knots = {std::vector<double>{0, 0, 0.5, 1, 1}, std::vector<double>{0, 0, 0.5, 1, 1}};
        for (const double v : {0.0, 0.5, 1.0})
            for (const double u : {0.0, 0.5, 1.0})
                patch.controlPoints.emplace_back(u, v, u == 0.5 && v == 0.5 ? height : 0);
        return patch;
    }

    [[nodiscard]] double height(std::size_t point) const { return lattice.targets.points[point][2]; }

    ReferenceGrid grid;
    LatticeSource source;
    FitLattice lattice;
};

TEST_F(LatticeErrors, FoldsCountAsErrorsButNotAsDistances) {
    Patch patch = lifted(0.05);
    const PatchErrors sound = latticeErrors(lattice, patch, 0.1);
    EXPECT_NEAR(sound.max(), 0.5, 1e-12);
    EXPECT_FALSE(sound.anyFolded());
    for (Point& point : patch.controlPoints)
        point[0] = 1 - point[0]; // mirrored: its normals point down
    for (std::size_t k = 0; k < 9; ++k)
        lattice.reference[k][0] = 1 - lattice.reference[k][0];
    const PatchErrors folded = latticeErrors(lattice, patch, 0.1);
    EXPECT_NEAR(folded.max(), 2, 1e-12);
    EXPECT_NEAR(folded.maxDistance(), 0.5, 1e-12);
    EXPECT_TRUE(folded.anyFolded());
    EXPECT_FALSE(latticeErrors(lattice, lifted(0.5), 0.1).anyFolded()) << "far away, but not folded";
    EXPECT_TRUE(latticeErrors(lattice, patch, 0.01).anyFolded()) << "far away and folded";
}

TEST_F(LatticeErrors, TargetsStayOnTheReferenceWithoutSlack) {
    slideTargets(raisedInTheMiddle(0.001), 0, lattice);
    EXPECT_NEAR(height(4), 0, 1e-5);
}

TEST_F(LatticeErrors, TargetsFollowWavesWithinTheSlack) {
    const Patch wave = raisedInTheMiddle(0.001);
    const double mean = 0.00025; // of a pyramid with weights of 1, 2 and 4
    for (int k = 0; k < 40; ++k)
        slideTargets(wave, 1, lattice);
    EXPECT_NEAR(height(4), 0.85 * (0.001 - mean), 1e-7);
    EXPECT_NEAR(height(1), -0.85 * mean, 1e-7);
}

TEST_F(LatticeErrors, TargetsStopWhereTheSlackEnds) {
    slideTargets(raisedInTheMiddle(-0.003), 0.001, lattice);
    EXPECT_NEAR(height(4), -0.001, 1e-5);
}

TEST_F(LatticeErrors, TheWholePatchIsNotFollowed) {
    slideTargets(lifted(0.05), 0.1, lattice);
    EXPECT_NEAR(height(4), 0, 1e-15);
}

TEST_F(LatticeErrors, WhatWasMissedHasLessSlack) {
    lattice.emphasis[4] = 10;
    slideTargets(raisedInTheMiddle(0.005), 0.001, lattice);
    EXPECT_NEAR(height(4), 0.0001, 1e-5);
}

TEST_F(LatticeErrors, CreasesAreFollowedWithoutSlack) {
    source.isCrease[0] = {true};
    lattice = makeLattice(source, lattice.targets.parameters);
    slideTargets(raisedInTheMiddle(0.002), 0.001, lattice);
    EXPECT_NEAR(height(1), 0, 1e-15);
    EXPECT_GT(height(4), 0.0005);
}

} // namespace
} // namespace qm
