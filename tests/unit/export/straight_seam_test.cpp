// Edges between two faces of one cylinder or cone become straight.
#include "export/simple/straight_seam.h"

#include <gtest/gtest.h>

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

constexpr double resolution = 1e-7;

SimpleSurface cylinder(double radius, double height = 0, const gp_Dir& seam = {1, 0, 0}) {
    return {new Geom_CylindricalSurface(gp_Ax3({0, 0, height}, {0, 0, 1}, seam), radius), false, 0};
}

/// Of half-angle 45 degrees, with its apex at the origin.
SimpleSurface cone(double height) {
    return {new Geom_ConicalSurface(gp_Ax3({0, 0, height}, {0, 0, 1}), std::numbers::pi / 4, height), false,
            0};
}

SimpleSurface plane(double height, double slope) {
    return {new Geom_Plane({0, 0, height}, gp_Dir(-slope, 0, 1)), false, 0};
}

TEST(StraightSeam, IsBetweenFacesOfOneSurfaceWhereverTheirParametersBegin) {
    EXPECT_TRUE(areOneRuledSurface(cylinder(2), cylinder(2, 5, {0, 1, 0}), resolution));
    EXPECT_FALSE(areOneRuledSurface(cylinder(2), cylinder(2.001), resolution));
    const SimpleSurface beside{new Geom_CylindricalSurface(gp_Ax3({0.001, 0, 0}, {0, 0, 1}), 2), false, 0};
    EXPECT_FALSE(areOneRuledSurface(cylinder(2), beside, resolution));
    EXPECT_TRUE(areOneRuledSurface(cone(1), cone(3), resolution));
    EXPECT_FALSE(areOneRuledSurface(cone(1), cylinder(1, 1), resolution));
    EXPECT_FALSE(areOneRuledSurface(plane(0, 0), plane(0, 0), resolution)) << "no side of a plane is a seam";
}

TEST(StraightSeam, EndsWhereItsLineMeetsTheOtherFaces) {
    const auto at = [](double angle, double height) {
        return gp_Pnt(2 * std::cos(angle), 2 * std::sin(angle), height);
    };
    const auto ends = straightened(cylinder(2), {at(0.1, 0), at(0.3, 3 + 0.5 * at(0.3, 0).X())},
                                   {{{plane(0, 0)}, {plane(3, 0.5), plane(3, 0.5)}}});
    ASSERT_TRUE(ends);
    EXPECT_LT((*ends)[0].Distance(at(0.2, 0)), 1e-12);
    EXPECT_LT((*ends)[1].Distance(at(0.2, 3 + 0.5 * at(0.2, 0).X())), 1e-9);
    const auto open = straightened(cylinder(2), {at(0.1, 0), at(0.3, 4)}, {});
    ASSERT_TRUE(open);
    EXPECT_LT((*open)[1].Distance(at(0.2, 4)), 1e-12);
}

TEST(StraightSeam, OfAConePointsAtItsApex) {
    const auto at = [](double angle, double height) {
        return gp_Pnt(height * std::cos(angle), height * std::sin(angle), height);
    };
    const auto ends = straightened(cone(1), {at(0.1, 1), at(0.3, 2)}, {{{plane(1, 0)}, {plane(2, 0)}}});
    ASSERT_TRUE(ends);
    EXPECT_LT((*ends)[0].Distance(at(0.2, 1)), 1e-9);
    EXPECT_LT((*ends)[1].Distance(at(0.2, 2)), 1e-9);
}

TEST(StraightSeam, DoesNotRunAround) {
    EXPECT_FALSE(straightened(cylinder(2), {gp_Pnt(2, 0, 0), gp_Pnt(0, 2, 0.1)}, {}));
    EXPECT_FALSE(straightened(cylinder(2), {gp_Pnt(2, 0, 0), gp_Pnt(-2, 0, 0.1)}, {}));
    EXPECT_FALSE(straightened(cylinder(2), {gp_Pnt(2, 0, 0), gp_Pnt(1.6, 1.2, 0)}, {}));
}

} // namespace
} // namespace qm
