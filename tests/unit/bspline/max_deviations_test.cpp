#include "bspline/measure/max_deviations.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "support/fitted_model.h"

#include <gtest/gtest.h>

#include <cmath>

namespace qm {
namespace {

/// A wavy strip of twelve patches in a row, fitted.
test::FittedModel row() {
    std::vector<test::Rectangle> rectangles;
    for (int k = 0; k < 12; ++k)
        rectangles.push_back({2 * k, 0, 2 * k + 2, 3, 0});
    const test::Grid strip{24, 3,
                           [](double i, double j) { return Point(i, j, std::sin(0.7 * i + 0.3 * j)); }};
    return test::fitted(strip, rectangles, {});
}

TEST(MaxDeviations, AreMeasuredAgainWhereAnythingHasChanged) {
    const test::FittedModel model = row();
    const std::vector<ReferenceGrid> facets = facetGrids(model.mesh, model.layout);
    const auto fresh = [&](const std::vector<Patch>& patches) {
        return MaxDeviations(model.mesh, model.layout, facets, 1e-6, 1)(patches);
    };
    MaxDeviations repeated(model.mesh, model.layout, facets, 1e-6, 2);
    std::vector<Patch> patches = model.surfaces.patches;
    EXPECT_EQ(repeated(patches), fresh(patches));
    EXPECT_EQ(repeated(patches), fresh(patches));
    for (const std::size_t changed : {std::size_t{0}, std::size_t{5}, std::size_t{11}}) {
        const std::vector<double> before = fresh(patches);
        for (Point& point : patches[changed].controlPoints)
            point[2] += 0.25;
        const std::vector<double> after = repeated(patches);
        EXPECT_EQ(after, fresh(patches));
        EXPECT_GT(after[changed], before[changed] + 0.1);
        patches[changed] = model.surfaces.patches[changed];
        EXPECT_EQ(repeated(patches), before);
    }
}

} // namespace
} // namespace qm
