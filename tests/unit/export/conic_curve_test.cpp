// Where simple surfaces meet in lines, circles and ellipses, and how pieces of these are continued.
#include "export/simple/conic_curve.h"

#include <gtest/gtest.h>

#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

constexpr double resolution = 1e-7;

SimpleSurface simple(const Handle(Geom_ElementarySurface) & surface) {
    return {surface, false, 0};
}

SimpleSurface plane(const gp_Pnt& point, const gp_Dir& normal) {
    return simple(new Geom_Plane(point, normal));
}

gp_Ax3 upright(double height = 0) {
    return {gp_Pnt(0, 0, height), gp_Dir(0, 0, 1)};
}

/// Of a circle around the third axis.
gp_Pnt around(double radius, double degrees, double height = 0) {
    const double angle = degrees * std::numbers::pi / 180;
    return {radius * std::cos(angle), radius * std::sin(angle), height};
}

const SimpleSurface cylinder = simple(new Geom_CylindricalSurface(upright(), 2));
const SimpleSurface floor = plane({0, 0, 0}, {0, 0, 1});

TEST(ConicCurve, OfTwoPlanesIsALineFromOneEndToTheOther) {
    const SimpleSurface wall = plane({0, 3, 0}, {0, 1, 0});
    for (const double to : {5.0, -5.0}) {
        const auto piece =
            conicCurve({floor, wall}, {gp_Pnt(1, 3, 0), gp_Pnt(to, 3, 0)}, {0, 3, 0}, resolution);
        ASSERT_TRUE(piece);
        EXPECT_TRUE(piece->curve->IsKind(STANDARD_TYPE(Geom_Line)));
        EXPECT_LT(piece->start().Distance({1, 3, 0}), 1e-12);
        EXPECT_LT(piece->end().Distance({to, 3, 0}), 1e-12);
        EXPECT_LT(piece->first, piece->last);
    }
}

TEST(ConicCurve, IsTheArcOnTheGivenSide) {
    for (const double middle : {45.0, 225.0})
        for (const bool isTurned : {false, true}) {
            std::array ends{around(2, 0), around(2, 90)};
            if (isTurned) std::swap(ends[0], ends[1]);
            const auto piece = conicCurve({cylinder, floor}, ends, around(2.01, middle), resolution);
            ASSERT_TRUE(piece);
            EXPECT_TRUE(piece->curve->IsKind(STANDARD_TYPE(Geom_Circle)));
            EXPECT_LT(piece->start().Distance(ends[0]), 1e-12);
            EXPECT_LT(piece->end().Distance(ends[1]), 1e-12);
            EXPECT_LT(piece->middle().Distance(around(2, middle)), 1e-12);
            EXPECT_GE(piece->first, 0);
            EXPECT_LT(piece->first, 2 * std::numbers::pi);
        }
}

TEST(ConicCurve, OfACylinderCutAtAnAngleIsAnEllipse) {
    const SimpleSurface slanted = plane({0, 0, 0}, {-0.6, 0, 0.8});
    const auto at = [](double degrees) {
        const gp_Pnt below = around(2, degrees);
        return gp_Pnt(below.X(), below.Y(), 0.75 * below.X());
    };
    const auto piece = conicCurve({slanted, cylinder}, {at(10), at(80)}, at(45), resolution);
    ASSERT_TRUE(piece);
    EXPECT_TRUE(piece->curve->IsKind(STANDARD_TYPE(Geom_Ellipse)));
    for (const double t : parametersOf(*piece, 4)) {
        EXPECT_NEAR(std::hypot(piece->at(t).X(), piece->at(t).Y()), 2, 1e-12);
        EXPECT_NEAR(piece->at(t).Z(), 0.75 * piece->at(t).X(), 1e-12);
    }
    // What differs from a circle by less than the resolution is one.
    const SimpleSurface hardly = plane({0, 0, 0}, {-1e-5, 0, 1});
    const auto circle = conicCurve({hardly, cylinder}, {around(2, 90), around(2, -90)}, around(2, 0), 1e-7);
    ASSERT_TRUE(circle);
    EXPECT_TRUE(circle->curve->IsKind(STANDARD_TYPE(Geom_Circle)));
}

TEST(ConicCurve, OfSurfacesOfRevolutionAroundOneAxisIsACircle) {
    const SimpleSurface cone = simple(new Geom_ConicalSurface(upright(-1), std::numbers::pi / 4, 1));
    const SimpleSurface sphere = simple(new Geom_SphericalSurface(upright(0), 2));
    const SimpleSurface torus = simple(new Geom_ToroidalSurface(upright(1), 2, 1));
    for (const auto& pair :
         {std::array{cone, cylinder}, std::array{cylinder, torus}, std::array{sphere, floor},
          std::array{floor, sphere}, std::array{torus, cylinder}}) {
        const auto piece = conicCurve(pair, {around(2, 30), around(2, 170)}, around(2, 100), resolution);
        ASSERT_TRUE(piece);
        EXPECT_TRUE(piece->curve->IsKind(STANDARD_TYPE(Geom_Circle)));
        EXPECT_LT(piece->middle().Distance(around(2, 100)), 1e-9);
    }
}

TEST(ConicCurve, IsALineAlongACylinderThatBothFacesAre) {
    const SimpleSurface same = simple(new Geom_CylindricalSurface(upright(1), 2));
    const auto piece =
        conicCurve({cylinder, same}, {around(2, 30), around(2, 30, 3)}, around(2, 31, 1), resolution);
    ASSERT_TRUE(piece);
    EXPECT_TRUE(piece->curve->IsKind(STANDARD_TYPE(Geom_Line)));
    EXPECT_FALSE(conicCurve({floor, floor}, {around(2, 0), around(2, 90)}, around(2, 45), resolution))
        << "a border within one plane may be bent";
}

TEST(ConicCurve, IsNothingWhereThereIsNone) {
    const SimpleSurface across = simple(new Geom_CylindricalSurface(gp_Ax3({0, 0, 0}, {1, 0, 0}), 1));
    const gp_Pnt start(std::sqrt(3), 1, 0); // on both cylinders
    const gp_Pnt end(2, 0, 1);
    EXPECT_FALSE(conicCurve({across, cylinder}, {start, end}, {1.9, 0.6, 0.8}, resolution))
        << "no plane curve";
    EXPECT_FALSE(
        conicCurve({cylinder, cylinder}, {around(2, 0), around(2, 45, 3)}, around(2, 22, 1), resolution))
        << "one surface";
    EXPECT_FALSE(conicCurve({cylinder, floor}, {around(2, 0), around(2, 90, 1)}, around(2, 45), resolution))
        << "an end is elsewhere";
    EXPECT_FALSE(conicCurve({cylinder, floor}, {around(2, 0), around(2, 0)}, around(2, 45), resolution));
}

CurvePiece arc(double from, double to, double middle) {
    return *conicCurve({cylinder, floor}, {around(2, from), around(2, to)}, around(2, middle), resolution);
}

TEST(Continued, GoesToTheFarEndOfTheSecondPiece) {
    for (const CurvePiece& after : {arc(100, 200, 150), arc(200, 100, 150)}) {
        const auto both = continued(arc(350, 100, 50), after, resolution);
        ASSERT_TRUE(both);
        EXPECT_LT(both->start().Distance(around(2, 350)), 1e-9);
        EXPECT_LT(both->end().Distance(around(2, 200)), 1e-9);
        EXPECT_LT(both->middle().Distance(around(2, 95)), 1e-9);
    }
    const SimpleSurface wall = plane({0, 3, 0}, {0, 1, 0});
    const auto stretch = [&](double from, double to) {
        return *conicCurve({floor, wall}, {gp_Pnt(from, 3, 0), gp_Pnt(to, 3, 0)}, {0, 3, 0}, resolution);
    };
    const auto line = continued(stretch(0, 1), stretch(4, 1), resolution);
    ASSERT_TRUE(line);
    EXPECT_LT(line->end().Distance({4, 3, 0}), 1e-12);
    EXPECT_FALSE(continued(stretch(0, 1), stretch(1, 0.5), resolution)) << "it turns back";
}

TEST(Continued, StaysOpenAndOnOneCurve) {
    EXPECT_FALSE(continued(arc(0, 100, 50), arc(100, 0, 200), resolution)) << "a whole circle";
    EXPECT_FALSE(continued(arc(0, 100, 50), arc(100, 50, 70), resolution)) << "it turns back";
    CurvePiece other = arc(100, 200, 150);
    other.curve = Handle(Geom_Curve)::DownCast(other.curve->Translated(gp_Vec(0, 0, 1e-5)));
    EXPECT_FALSE(continued(arc(0, 100, 50), other, resolution));
}

TEST(CurvePiece, IsCoveredByItsControlPoints) {
    double length = 0;
    const auto points = controlPoints(arc(0, 180, 90));
    for (std::size_t k = 1; k < points.size(); ++k)
        length += points[k - 1].Distance(points[k]);
    EXPECT_GT(length, 2 * std::numbers::pi);
    EXPECT_LT(length, 12);
    EXPECT_EQ(parametersOf(arc(0, 180, 90), 3).size(), 4U * 3 + 1);
}

} // namespace
} // namespace qm
