/// \file Patches as cylinders, cones, spheres and tori.
#include "support/exported_shape.h"

#include <gtest/gtest.h>

#include <BRepGProp.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace qm {
namespace {

using test::all;
using test::analytic;
using test::countSurfaces;
using test::fitted;
using test::FittedModel;
using test::Grid;
using test::readBack;
using test::revolved;

TEST(Analytic, EveryKindIsRecognised) {
    for (const bool inwards : {false, true}) {
        const TopoDS_Shape cylinder = readBack(revolved([](double) { return 3.0; }, inwards), analytic());
        EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(cylinder), 2) << inwards;
        const TopoDS_Shape cone =
            readBack(revolved([](double z) { return 4 - 0.5 * z; }, inwards), analytic());
        EXPECT_EQ(countSurfaces<Geom_ConicalSurface>(cone), 2) << inwards;
        const TopoDS_Shape sphere = readBack(
            revolved([](double z) { return std::sqrt(16 - (z - 1.2) * (z - 1.2)); }, inwards), analytic());
        EXPECT_EQ(countSurfaces<Geom_SphericalSurface>(sphere), 2) << inwards;
        const TopoDS_Shape none =
            readBack(revolved([](double z) { return 3 + 0.2 * std::sin(2 * z); }, inwards), analytic());
        EXPECT_EQ(countSurfaces<Geom_BSplineSurface>(none), 2) << inwards;
    }
}

TEST(Analytic, FitsMayWaveWithinTheTolerance) {
    const auto rim = [](double height) {
        return [height](double z) { return 3 + height * std::exp(-z * z / 0.09); };
    };
    ExportOptions options = analytic();
    options.analyticTolerance = {0.5, true};
    EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(readBack(revolved(rim(0.03), false), options)), 2);
    options.analyticTolerance = {3, true};
    EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(readBack(revolved(rim(0.2), false), options)), 0)
        << "this is a rim";
}

TEST(Analytic, WhatBendsHardlyMoreThanItWavesIsNothing) {
    const auto bent = [](double wave) {
        return fitted(Grid{10, 10,
                           [wave](double i, double j) {
                               return Point(
                                   i, j, 0.006 * i * (10 - i) + wave * std::sin(0.4 * std::numbers::pi * j));
                           }},
                      {{0, 0, 10, 10}}, test::interpolating());
    };
    ExportOptions options = analytic();
    options.analyticTolerance = {0.35, true};
    EXPECT_EQ(countSurfaces<Geom_CylindricalSurface>(readBack(bent(0.02), options)), 1);
    EXPECT_EQ(countSurfaces<Geom_BSplineSurface>(readBack(bent(0.045), options)), 1)
        << "within the tolerance of many surfaces";
}

/// Between the origin and the faces; OpenCASCADE's own volume of an open shell depends on its vertices.
double volumeFromOrigin(const TopoDS_Shape& shape) {
    double sum = 0;
    for (const TopoDS_Shape& face : all(shape, TopAbs_FACE)) {
        BRepGProp_Face integrated(TopoDS::Face(face));
        BRepGProp_Domain domain(TopoDS::Face(face));
        sum += BRepGProp_Vinert(integrated, domain, gp_Pnt(), gp_Pnt()).Mass();
    }
    return sum;
}

TEST(Analytic, FacesLookToTheSameSideAsPatches) {
    for (const bool inwards : {false, true}) {
        const FittedModel model = revolved([](double) { return 3.0; }, inwards);
        EXPECT_NEAR(volumeFromOrigin(readBack(model)), volumeFromOrigin(readBack(model, analytic())), 1e-2);
    }
}

double volume(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

class Tori : public testing::TestWithParam<std::vector<std::array<int, 4>>> {};

TEST_P(Tori, AreToriWhereverTheyAreCut) {
    const FittedModel model = test::torus(GetParam());
    const TopoDS_Shape shape = readBack(model, analytic());
    EXPECT_EQ(countSurfaces<Geom_ToroidalSurface>(shape), static_cast<int>(all(shape, TopAbs_FACE).size()));
    EXPECT_EQ(all(shape, TopAbs_SOLID).size(), 1U);
    EXPECT_NEAR(volume(shape), 2 * std::numbers::pi * 5 * std::numbers::pi * 4, 0.2);
    for (const TopoDS_Shape& edge : all(shape, TopAbs_EDGE))
        EXPECT_LE(BRep_Tool::Tolerance(TopoDS::Edge(edge)), 1.0001e-7) << "all faces are one torus";
    EXPECT_EQ(countSurfaces<Geom_ToroidalSurface>(readBack(model)), 0) << "only on request";
}

INSTANTIATE_TEST_SUITE_P(
    All, Tori,
    testing::Values(std::vector<std::array<int, 4>>{{0, 0, 16, 12}},
                    std::vector<std::array<int, 4>>{{0, 0, 9, 12}, {9, 0, 16, 4}, {9, 4, 16, 12}},
                    std::vector<std::array<int, 4>>{{3, 5, 11, 13}, {11, 5, 19, 13}, {3, 1, 19, 5}}));

} // namespace
} // namespace qm
