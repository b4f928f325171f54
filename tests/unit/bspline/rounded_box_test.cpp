#include "bspline/fit.h"
#include "mesh/dihedral.h"
#include "support/cheapest_layout.h"
#include "support/rounded_box.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace qm {
namespace {

using test::RoundedBox;

Surfaces surfacesOf(const QuadMesh& mesh) {
    return fitSurfaces(mesh, test::cheapestLayout(mesh), dihedralAngles(mesh), {});
}

std::size_t controlPoints(const Surfaces& surfaces) {
    std::size_t count = 0;
    for (const Patch& patch : surfaces.patches)
        count += patch.controlPoints.size();
    return count;
}

TEST(RoundedBox, PatchesThatFoldWithFewKnotsBeginWithMore) {
    const RoundedBox box(6, 24);
    const Surfaces surfaces = surfacesOf(box.mesh());
    EXPECT_EQ(missedTolerance(surfaces, {}), "");
    EXPECT_TRUE(surfaces.folds.empty());
    EXPECT_LT(controlPoints(surfaces), 2000U);
}

TEST(RoundedBox, WideQuadsBesideNarrowOnesDoNotFold) {
    for (const int flat : {3, 4}) {
        const RoundedBox box(6, flat);
        const Surfaces surfaces = surfacesOf(box.mesh());
        EXPECT_EQ(missedTolerance(surfaces, {}), "") << flat;
        EXPECT_TRUE(surfaces.folds.empty()) << flat;
    }
}

TEST(RoundedBox, MayHaveASingleQuadOnEveryFlat) {
    for (const double radius : {4.0, 2.0}) {
        for (const int fillet : {4, 8}) {
            const RoundedBox box(fillet, 1, radius);
            const Surfaces surfaces = surfacesOf(box.mesh());
            EXPECT_EQ(missedTolerance(surfaces, {}), "") << radius << ' ' << fillet;
            EXPECT_TRUE(surfaces.folds.empty()) << radius << ' ' << fillet;
            EXPECT_LT(controlPoints(surfaces), 2500U) << radius << ' ' << fillet;
        }
    }
}

} // namespace
} // namespace qm
