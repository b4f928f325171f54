#include "export/boundary/divided_edges.h"
#include "export/geometry/geometry.h"

#include <gtest/gtest.h>

#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <algorithm>
#include <gp_Pln.hxx>

namespace qm {
namespace {

/// A cubic from (0, 0, 0) to (1, 0, 0) that rises above the plane z = 0.
Handle(Geom_BSplineCurve) arch(const std::array<double, 2>& heights) {
    return splineCurve(
        {{0, 0, 0, 0, 1, 1, 1, 1},
         {Point(0, 0, 0), Point(1.0 / 3, 0, heights[0]), Point(2.0 / 3, 0, heights[1]), Point(1, 0, 0)}});
}

/// Two triangles in the plane z = 0 on both sides of an edge that need not lie in it.
Boundary twoTriangles(const Handle(Geom_BSplineCurve) & shared) {
    Boundary boundary;
    boundary.resolution = 1e-7;
    for (const gp_Pnt& point : {gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0), gp_Pnt(0, 1, 0), gp_Pnt(0, -1, 0)})
        boundary.vertices.push_back({point, 1e-7});
    const auto addLine = [&](std::size_t from, std::size_t to) {
        const gp_Vec along(boundary.vertices[from].point, boundary.vertices[to].point);
        BoundaryEdge edge;
        edge.curve = {new Geom_Line(boundary.vertices[from].point, gp_Dir(along)), 0, along.Magnitude()};
        edge.ends = {from, to};
        boundary.edges.push_back(edge);
    };
    BoundaryEdge edge;
    edge.curve = wholeCurve(shared);
    edge.ends = {0, 1};
    edge.tolerance = 0.01;
    boundary.edges.push_back(edge);
    addLine(1, 2);
    addLine(2, 0);
    addLine(0, 3);
    addLine(3, 1);
    const Handle(Geom_Surface) plane = new Geom_Plane(gp_Pln());
    boundary.faces.push_back({plane, false, true, {{{0, true}, {1, true}, {2, true}}}});
    boundary.faces.push_back({plane, false, true, {{{3, true}, {4, true}, {0, false}}}});
    return boundary;
}

void expectClosedLoops(const Boundary& boundary) {
    for (const BoundaryFace& face : boundary.faces)
        for (const auto& loop : face.loops)
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const EdgeUse& use = loop[k];
                const EdgeUse& next = loop[(k + 1) % loop.size()];
                EXPECT_EQ(boundary.edges[use.edge].ends.at(use.forwards ? 1 : 0),
                          boundary.edges[next.edge].ends.at(next.side()));
            }
}

TEST(LooseEdges, AreDividedWhereTheyAreFarthest) {
    const auto curve = arch({0.01, 0.002});
    Boundary boundary = twoTriangles(curve);
    EXPECT_TRUE(divideLooseEdges(boundary));
    ASSERT_EQ(boundary.edges.size(), 6U);
    ASSERT_EQ(boundary.vertices.size(), 5U);
    expectClosedLoops(boundary);
    EXPECT_EQ(boundary.faces[0].loops[0].size(), 4U);
    EXPECT_EQ(boundary.faces[1].loops[0].size(), 4U);
    double highest = 0;
    for (int k = 0; k <= 1000; ++k)
        highest = std::max(highest, curve->Value(k / 1000.0).Z());
    const gp_Pnt middle = boundary.vertices.back().point;
    EXPECT_NEAR(middle.Z(), highest, 1e-8);
    EXPECT_LT(middle.X(), 0.45) << "where it is highest";
    for (const std::size_t part : {std::size_t{0}, std::size_t{5}}) {
        const BoundaryEdge& edge = boundary.edges[part];
        EXPECT_EQ(edge.tolerance, 0.01);
        EXPECT_LT(edge.curve.start().Distance(boundary.vertices[edge.ends[0]].point), 1e-12);
        EXPECT_LT(edge.curve.end().Distance(boundary.vertices[edge.ends[1]].point), 1e-12);
    }
}

TEST(LooseEdges, StayWholeWhereThatHelpsNothing) {
    Boundary flat = twoTriangles(arch({0, 0}));
    EXPECT_FALSE(divideLooseEdges(flat));
    EXPECT_EQ(flat.edges.size(), 5U);
    Boundary steep = twoTriangles(arch({0.5, 0.5}));
    EXPECT_FALSE(divideLooseEdges(steep)) << "parts would be hardly longer than their distance";
}

} // namespace
} // namespace qm
