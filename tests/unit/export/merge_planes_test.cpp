/// \file Planes, and faces in one plane as one.
#include "support/exported_shape.h"

#include <gtest/gtest.h>

#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <array>
#include <vector>

namespace qm {
namespace {

using test::all;
using test::area;
using test::countSurfaces;
using test::fitted;
using test::FittedModel;
using test::Grid;
using test::joining;
using test::readBack;
using test::sheet;

TEST(Planes, AreExportedAsPlanes) {
    const Grid grid{6, 4, [](double i, double j) { return Point(i, j + 0.05 * j * j, i < 3 ? 0 : i - 3); }};
    const FittedModel model = fitted(grid, {{0, 0, 3, 4}, {3, 0, 6, 4}}, {});
    const TopoDS_Shape shape = readBack(model);
    EXPECT_EQ(countSurfaces<Geom_Plane>(shape), 2);
    const FittedModel wavy = fitted(sheet(), test::tJoint(), FitOptions());
    EXPECT_EQ(countSurfaces<Geom_Plane>(readBack(wavy)), 0);
}

/// A flat sheet of N x N squares with one patch each; those at the given places have a peak in the middle.
FittedModel peaks(const std::vector<std::array<int, 2>>& places, int squaresAlong = 3) {
    const int size = 2 * squaresAlong;
    const auto isPeak = [=](double i, double j) {
        return std::ranges::any_of(places, [=](auto at) { return i == 2 * at[0] + 1 && j == 2 * at[1] + 1; });
    };
    const Grid grid{size, size, [=](double i, double j) { return Point(i, j, isPeak(i, j) ? 2 : 0); }};
    std::vector<test::Rectangle> squares;
    for (int j = 0; j < size; j += 2)
        for (int i = 0; i < size; i += 2)
            squares.push_back({i, j, i + 2, j + 2});
    return fitted(grid, squares, FitOptions());
}

TEST(MergePlanes, MakesOneFaceWithAHole) {
    const FittedModel model = peaks({{1, 1}});
    EXPECT_EQ(all(readBack(model), TopAbs_FACE).size(), 9U);
    const TopoDS_Shape shape = readBack(model, joining());
    const auto faces = all(shape, TopAbs_FACE);
    ASSERT_EQ(faces.size(), 2U);
    EXPECT_EQ(all(faces[1], TopAbs_EDGE).size(), 4U) << "the hole's";
    EXPECT_EQ(all(faces[0], TopAbs_WIRE).size(), 2U);
    EXPECT_FALSE(Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(TopoDS::Face(faces[0]))).IsNull());
    EXPECT_NEAR(area(faces[0]), 32, 0.01);
    const std::string step = exportModel(model.mesh, model.layout, &model.surfaces, joining()).bytes;
    EXPECT_NE(step.find("ADVANCED_FACE('segments 0 1 2 3 5 6 7 8'"), std::string::npos);
    const ShapeReport report = *exportModel(model.mesh, model.layout, &model.surfaces, joining()).shape;
    EXPECT_EQ(report.faces, 2U);
    EXPECT_EQ(report.simpleFaces, 1U);
    EXPECT_EQ(report.openEdges + 4, report.edges);
}

TEST(MergePlanes, NamesAsManySegmentsAsFitIntoFiftyBytes) { // where Netgen keeps names
    for (const auto& [along, name] : {std::pair{4, "segments 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15"},
                                      std::pair{5, "segments 0 1 2 3 4 5 6 7 8 9 10 11 12 and 12 more"}}) {
        const FittedModel model = peaks({}, along);
        const std::string step = exportModel(model.mesh, model.layout, &model.surfaces, joining()).bytes;
        EXPECT_NE(step.find("ADVANCED_FACE('" + std::string(name) + "'"), std::string::npos) << along;
        EXPECT_LT(std::string(name).size(), 50U);
    }
}

TEST(MergePlanes, LeavesNoVertexOnAnOutlineTwice) {
    const TopoDS_Shape shape = readBack(peaks({{1, 1}, {2, 2}}), joining());
    EXPECT_EQ(countSurfaces<Geom_Plane>(shape), 2) << "the seven squares around both meet themselves";
    for (const TopoDS_Shape& face : all(shape, TopAbs_FACE))
        EXPECT_EQ(all(face, TopAbs_VERTEX).size(), all(face, TopAbs_EDGE).size());
}

} // namespace
} // namespace qm
