#include "export/files/step_geometry.h"

#include <gtest/gtest.h>

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <cmath>
#include <regex>
#include <string>

namespace qm {
namespace {

Handle(Geom2d_BSplineCurve) line(const gp_Pnt2d& from, const gp_Pnt2d& to) {
    TColgp_Array1OfPnt2d poles(1, 2);
    poles(1) = from;
    poles(2) = to;
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = 0;
    knots(2) = 1;
    TColStd_Array1OfInteger times(1, 2);
    times.Init(2);
    return new Geom2d_BSplineCurve(poles, knots, times, 1);
}

/// The parameter v at the end of a line from (0, 0) to (1, 2) in a surface's parameter plane, as written.
double writtenHeight(const Handle(Geom_Surface) & surface) {
    StepFile file;
    (void)addPlaneCurve(file, line({0, 0}, {1, 2}), surface);
    const std::string text = file.text({"", ""}, "");
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
