#include "bspline/splines/clamped_patch.h"
#include "export/boundary/divided_edges.h"
#include "export/geometry/geometry.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace qm {
namespace {

const std::vector<double> oneInterval{0, 0, 0, 0, 1, 1, 1, 1};

/// A Bezier patch.
Patch patch(const std::function<Point(double, double)>& place) {
    Patch result;
    result.count = {4, 4};
    result.knots = {oneInterval, oneInterval};
    for (const double v : {0.0, 1 / 3.0, 2 / 3.0, 1.0})
        for (const double u : {0.0, 1 / 3.0, 2 / 3.0, 1.0})
            result.controlPoints.push_back(place(u, v));
    return result;
}

/// Rulings from an arch, whose tangents turn by 33 degrees, that turn by an angle along it: so do the
/// normals.
Patch twisted(double degrees, double height = 0.1) {
    return patch([=](double u, double v) {
        const double angle = degrees * u * std::numbers::pi / 180;
        const double rise = u > 0 && u < 1 ? height : 0;
        return Point(u, rise + v * std::cos(angle), v * std::sin(angle));
    });
}

/// One face, and its four sides.
Boundary faceOf(const Patch& patch) {
    Boundary boundary;
    boundary.resolution = 1e-7;
    const std::array<gp_Pnt2d, 4> corners{gp_Pnt2d(0, 0), gp_Pnt2d(1, 0), gp_Pnt2d(1, 1), gp_Pnt2d(0, 1)};
    std::vector<EdgeUse> loop;
    for (std::size_t side = 0; side < 4; ++side) {
        BoundaryEdge edge;
        edge.curve = wholeCurve(splineCurve(borderCurve(patch, static_cast<int>(side))));
        edge.onFaces[0] = line(corners.at(side), corners.at((side + 1) % 4), 0, 1);
        edge.ends = {side, (side + 1) % 4};
        boundary.vertices.push_back({edge.curve.start(), 1e-7});
        boundary.edges.push_back(edge);
        loop.push_back({side, true});
    }
    boundary.faces.push_back({splineSurface(patch), false, false, {loop}});
    return boundary;
}

TEST(TwistedEdges, AreDividedWhereNormalsTurn) {
    Boundary boundary = faceOf(twisted(110));
    EXPECT_TRUE(divideTwistedEdges(boundary));
    const std::vector<EdgeUse>& loop = boundary.faces[0].loops[0];
    ASSERT_GE(loop.size(), 5U);
    EXPECT_EQ(loop[0].edge, 0U);
    EXPECT_EQ(loop[1].edge, 4U);
    EXPECT_LT(boundary.edges[0].curve.end().Distance(gp_Pnt(0.5, 0.075, 0)), 1e-12);
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const BoundaryEdge& edge = boundary.edges[loop[k].edge];
        EXPECT_EQ(edge.ends[1], boundary.edges[loop[(k + 1) % loop.size()].edge].ends[0]);
        const gp_Pnt2d on = edge.onFaces[0]->EndPoint();
        EXPECT_LT(boundary.faces[0].surface->Value(on.X(), on.Y()).Distance(edge.curve.end()), 1e-12);
    }
    EXPECT_FALSE(divideTwistedEdges(boundary)) << "they turn by half as much";
}

TEST(TwistedEdges, AreDividedOnceMoreIfNecessary) {
    Boundary boundary = faceOf(twisted(170));
    EXPECT_TRUE(divideTwistedEdges(boundary));
    EXPECT_NEAR(boundary.edges[0].curve.end().X(), 0.25, 1e-12);
}

TEST(TwistedEdges, StayWholeWhereTheyTurnAsTheNormalsDo) {
    Boundary little = faceOf(twisted(50));
    EXPECT_FALSE(divideTwistedEdges(little));
    Boundary straight = faceOf(twisted(110, 0));
    divideTwistedEdges(straight);
    EXPECT_EQ(straight.faces[0].loops[0][1].edge, 1U) << "the first side is its own chord";
    Boundary bent = faceOf(patch([](double u, double v) {
        return Point(u < 0.5 ? -1 : 1, v, u > 0 && u < 1 ? 1.3 : 0); // half a turn, nearly
    }));
    EXPECT_FALSE(divideTwistedEdges(bent));
    EXPECT_EQ(bent.edges.size(), 4U);
}

} // namespace
} // namespace qm
