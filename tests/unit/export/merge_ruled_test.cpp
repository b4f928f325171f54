/// \file Faces on one cylinder as one.
#include "support/exported_shape.h"

#include <gtest/gtest.h>

#include <Geom_CylindricalSurface.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <numbers>

namespace qm {
namespace {

using test::all;
using test::analytic;
using test::area;
using test::countSurfaces;
using test::FittedModel;
using test::joiningAnalytic;
using test::pinwheel;
using test::readBack;
using test::revolved;
using test::tube;

TEST(MergeRuled, MakesOneFaceOfAPartOfACylinder) {
    const FittedModel model = tube();
    EXPECT_EQ(all(readBack(model, analytic()), TopAbs_FACE).size(), 9U);
    const TopoDS_Shape shape = readBack(model, joiningAnalytic());
    EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(shape), 2) << "halves, as none may meet itself";
    EXPECT_EQ(all(shape, TopAbs_FACE).size(), 2U);
    EXPECT_NEAR(area(shape), 2 * std::numbers::pi * 3 * 3.2, 0.01);
    for (const TopoDS_Shape& face : all(shape, TopAbs_FACE))
        EXPECT_NEAR(area(face), std::numbers::pi * 3 * 3.2, 0.01);
}

TEST(MergeRuled, FacesMayHaveHoles) {
    for (const double bump : {0.5, -0.5}) {
        const TopoDS_Shape shape = readBack(tube(bump), joiningAnalytic());
        EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(shape), 2);
        const auto faces = all(shape, TopAbs_FACE);
        ASSERT_EQ(faces.size(), 3U);
        EXPECT_EQ(all(faces[0], TopAbs_WIRE).size(), 2U);
        EXPECT_NEAR(area(faces[0]), 3 * (std::numbers::pi * 3.2 - std::numbers::pi / 3 * 0.8), 0.01);
    }
}

TEST(MergeRuled, WhatDoesNotGoAroundIsOneFace) {
    auto rectangles = pinwheel(0, 60);
    std::swap(rectangles[1], rectangles.back());
    const FittedModel sheet = revolved([](double) { return 3.0; }, false, rectangles);
    const TopoDS_Shape shape = readBack(sheet, joiningAnalytic());
    EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(shape), 1);
    EXPECT_EQ(all(shape, TopAbs_FACE).size(), 1U);
    EXPECT_NEAR(area(shape), 0.06 * 60 * 3 * 3.2, 0.01);
}

} // namespace
} // namespace qm
