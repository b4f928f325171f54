/// \file Faces of STEP files are smooth, whatever the patches.
#include "support/exported_shape.h"

#include <gtest/gtest.h>

#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>

namespace qm {
namespace {

using test::all;
using test::countSmoothEdges;
using test::FittedModel;
using test::readBack;

TEST(Separate, ReadersFindOnlySmoothSurfaces) {
    const TopoDS_Shape shape = readBack(test::bentSheet(test::Bend::sharp));
    EXPECT_EQ(all(shape, TopAbs_FACE).size(), 2U);
    EXPECT_EQ(countSmoothEdges(shape), 0);
    for (const TopoDS_Shape& face : all(shape, TopAbs_FACE))
        EXPECT_GE(BRep_Tool::Surface(TopoDS::Face(face))->Continuity(), GeomAbs_C1);
}

TEST(Separate, LeavesASmoothSurfaceWhole) {
    const FittedModel model = test::bentSheet(test::Bend::none);
    const TopoDS_Shape shape = readBack(model);
    ASSERT_EQ(all(shape, TopAbs_FACE).size(), 1U) << "its triple knot is not needed";
    const auto surface = Handle(Geom_BSplineSurface)::DownCast(
        BRep_Tool::Surface(TopoDS::Face(all(shape, TopAbs_FACE).front())));
    ASSERT_FALSE(surface.IsNull());
    for (int k = 2; k < surface->NbUKnots(); ++k)
        EXPECT_EQ(surface->UMultiplicity(k), 1);
}

TEST(QuarterTurn, NoFaceHasMoreKnotsAlongU) {
    const FittedModel model = test::torus({{0, 0, 16, 12}});
    for (const TopoDS_Shape& face : all(readBack(model), TopAbs_FACE)) {
        const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(face)));
        ASSERT_FALSE(surface.IsNull());
        EXPECT_GE(surface->NbVKnots(), surface->NbUKnots());
    }
}

} // namespace
} // namespace qm
