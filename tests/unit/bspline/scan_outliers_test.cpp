#include "bspline/reference/scan/scan_outliers.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace qm::test {
namespace {

/// A square of the plane z = 0, with normals upwards.
struct Square {
    static constexpr int size = 8; ///< lattice steps along a side
    std::vector<ReferenceGrid> surface;
    LatticeNormals lattice;

    Square() {
        ReferenceGrid grid;
        grid.size = {size / 2, size / 2};
        grid.steps = 2;
        const Eigen::Vector3d up(0, 0, 1);
        lattice.numbers.emplace_back();
        lattice.oneSided.emplace_back();
        for (int j = 0; j <= size; ++j)
            for (int i = 0; i <= size; ++i) {
                const Eigen::Vector3d place(i, j, 0);
                grid.points.push_back(point(place));
                lattice.numbers.front().push_back(lattice.points.size());
                lattice.oneSided.front().emplace_back(up);
                lattice.points.push_back(place);
                lattice.normals.emplace_back(up);
                lattice.sharp.push_back(false);
            }
        surface.push_back(grid);
    }
    [[nodiscard]] ScanTargets targets(double height) const {
        return {lattice, surface, std::vector<Displacement>(lattice.points.size(), {{0, 0, height}})};
    }
};

constexpr std::size_t middle = 4 * (Square::size + 1) + 4;

TEST(ScanOutliers, APointThatJumpsOutWeighsNothingAndAllOthersWeighOne) {
    const Square square;
    ScanTargets targets = square.targets(0.5);
    (*targets.displacements[middle])[2] = 1;
    weighOutliers(targets, 0.01);
    EXPECT_EQ(targets.noise, 0);
    for (std::size_t k = 0; k < targets.weights.size(); ++k)
        EXPECT_EQ(targets.weights[k], k == middle ? 0 : 1) << k;
}

TEST(ScanOutliers, DifferencesBelowTheStepAreNone) {
    const Square square;
    ScanTargets targets = square.targets(0.5);
    (*targets.displacements[middle])[2] = 0.501;
    weighOutliers(targets, 0.01);
    EXPECT_GT(targets.weights[middle], 0.99);
}

TEST(ScanOutliers, ASharpPointThatJumpsOutOfItsEdgeIsDropped) {
    Square square;
    for (std::size_t i = 0; i <= Square::size; ++i)
        square.lattice.sharp[i] = true;
    ScanTargets targets = square.targets(0.5);
    (*targets.displacements[4])[1] = 1;
    dropSharpOutliers(targets, 0.01);
    for (std::size_t k = 0; k < targets.weights.size(); ++k)
        EXPECT_EQ(targets.weights[k], k == 4 ? 0 : 1) << k;
}

} // namespace
} // namespace qm::test
