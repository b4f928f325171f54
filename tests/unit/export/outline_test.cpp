#include "export/boundary/outline.h"

#include <gtest/gtest.h>

#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <gp_Pln.hxx>

namespace qm {
namespace {

/// A plane face whose loop has straight edges; gaps of the given length are at all vertices.
Boundary polygon(const std::vector<std::array<double, 2>>& corners, double gap = 0) {
    Boundary boundary;
    std::vector<EdgeUse> loop;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto& from = corners[k];
        const auto& to = corners[(k + 1) % corners.size()];
        boundary.vertices.push_back({gp_Pnt(from[0], from[1], 0)});
        const gp_Pnt start(from[0], from[1], 0);
        const gp_Vec along(start, gp_Pnt(to[0], to[1], 0));
        BoundaryEdge edge;
        edge.curve = {new Geom_Line(start, gp_Dir(along)), -gap, along.Magnitude() + gap};
        edge.ends = {k, (k + 1) % corners.size()};
        boundary.edges.push_back(edge);
        loop.push_back({k, true});
    }
    boundary.faces.push_back({new Geom_Plane(gp_Pln()), false, true, {loop}});
    return boundary;
}

TEST(Outline, CrossesItselfOrDoesNot) {
    EXPECT_FALSE(outlineCrossesItself(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), 0));
    EXPECT_FALSE(outlineCrossesItself(polygon({{0, 0}, {2, 0}, {1, 0.5}, {2, 2}, {0, 2}}), 0));
    EXPECT_TRUE(outlineCrossesItself(polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), 0));
}

TEST(Outline, SmallGapsAtVerticesDoNotCount) {
    EXPECT_FALSE(outlineCrossesItself(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1e-4), 0));
    EXPECT_TRUE(outlineCrossesItself(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.1), 0));
}

} // namespace
} // namespace qm
