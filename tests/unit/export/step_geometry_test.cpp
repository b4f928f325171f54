#include "export/files/step_geometry.h"

#include <gtest/gtest.h>

#include <GCE2d_MakeSegment.hxx>
#include <Geom2dConvert.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <cmath>
#include <regex>
#include <string>

namespace qm {
namespace {

/// The parameter v at the end of a line from (0, 0) to (1, 2) in a surface's parameter plane, as written.
double writtenHeight(const Handle(Geom_Surface) & surface) {
    StepFile file;
    const Handle(Geom2d_Curve) segment(GCE2d_MakeSegment(gp_Pnt2d(0, 0), gp_Pnt2d(1, 2)).Value());
    (void)addPlaneCurve(file, Geom2dConvert::CurveToBSplineCurve(segment), surface);
    const std::string text = file.text("", "", "");
    const std::regex point(R"(CARTESIAN_POINT\('',\(1\.?,([^,)]+)\)\))");
    std::smatch found;
    EXPECT_TRUE(std::regex_search(text, found, point)) << text;
    return found.empty() ? 0 : std::stod(found[1]);
}

TEST(StepGeometry, HeightsOnConesAreMeasuredOnTheAxis) {
    constexpr double halfAngle = 0.4;
    EXPECT_EQ(writtenHeight(new Geom_CylindricalSurface(gp_Ax3(), 3)), 2);
    EXPECT_DOUBLE_EQ(writtenHeight(new Geom_ConicalSurface(gp_Ax3(), halfAngle, 3)), 2 * std::cos(halfAngle));
}

} // namespace
} // namespace qm
