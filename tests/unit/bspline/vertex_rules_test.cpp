#include "base/at.h"
#include "bspline/network/vertex_rules.h"
#include "support/grid_layout.h"
#include "support/limit_sample.h"
#include "support/quad_layout.h"
#include "support/star_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace qm {
namespace {

using Kind = VertexRule::Kind;
using test::bentFan;
using test::creasesAndBoundary;
using test::Grid;
using test::noCreases;
using test::segmentPerQuad;

HalfedgeId halfedge(const QuadMesh& mesh, int from, int to) {
    return mesh.find_halfedge(VertexId(from), VertexId(to));
}

std::vector<bool> creaseAlong(const QuadMesh& mesh, const std::vector<std::array<int, 2>>& edges) {
    std::vector<bool> creases = noCreases(mesh);
    for (const auto& [from, to] : edges)
        creases[at(mesh.edge_handle(halfedge(mesh, from, to)))] = true;
    return creases;
}

VertexRule ruleAt(const QuadMesh& mesh, const Layout& layout, const std::vector<bool>& creases, int vertex) {
    return vertexRules(mesh, layout, creasesAndBoundary(mesh, creases))[at(vertex)];
}

TEST(VertexRules, ACreaseThatEndsIsADartAndOneWithoutEndACurve) {
    const QuadMesh mesh = bentFan(4);
    const Layout layout = segmentPerQuad(mesh);
    EXPECT_EQ(ruleAt(mesh, layout, noCreases(mesh), 0).kind, Kind::smooth);
    const VertexRule dart = ruleAt(mesh, layout, creaseAlong(mesh, {{0, 1}}), 0);
    EXPECT_EQ(dart.kind, Kind::dart);
    EXPECT_EQ(dart.along[0], halfedge(mesh, 0, 1));
    EXPECT_EQ(ruleAt(mesh, layout, creaseAlong(mesh, {{0, 1}, {0, 5}}), 0).kind, Kind::crease);
    EXPECT_EQ(ruleAt(mesh, layout, creaseAlong(mesh, {{0, 1}, {0, 3}}), 0).kind, Kind::corner);
    EXPECT_EQ(ruleAt(mesh, layout, creaseAlong(mesh, {{0, 1}, {0, 3}, {0, 5}}), 0).kind, Kind::corner);
}

TEST(VertexRules, CreasesThatTurnSharplyOrLeaveOneQuadBetweenThemMakeACorner) {
    const QuadMesh five = bentFan(5);
    const Layout layout = segmentPerQuad(five);
    EXPECT_EQ(ruleAt(five, layout, creaseAlong(five, {{0, 1}, {0, 5}}), 0).kind, Kind::crease);
    EXPECT_EQ(ruleAt(five, layout, creaseAlong(five, {{0, 1}, {0, 3}}), 0).kind, Kind::corner);
    const QuadMesh eight = bentFan(8);
    EXPECT_EQ(ruleAt(eight, segmentPerQuad(eight), creaseAlong(eight, {{0, 1}, {0, 5}}), 0).kind,
              Kind::corner)
        << "they turn by a right angle";
    EXPECT_EQ(ruleAt(eight, segmentPerQuad(eight), creaseAlong(eight, {{0, 1}, {0, 7}}), 0).kind,
              Kind::crease)
        << "they turn by half a right angle";
}

TEST(VertexRules, ASideThatPassesKeepsTheCurveSmoothWhateverEndsThere) {
    const Grid sheet{4, 4, [](double i, double j) { return Point(i, j, 0); }};
    const QuadMesh mesh = test::makeMesh(sheet);
    // The middle row has the vertices 10 to 14; a crease runs along it, and another one ends on it at 12 from
    // above.
    const std::vector<bool> creases = creaseAlong(mesh, {{10, 11}, {11, 12}, {12, 13}, {13, 14}, {12, 17}});
    const VertexRule passed = ruleAt(
        mesh, test::makeLayout(sheet, {{0, 0, 4, 2, 1}, {0, 2, 2, 4, 0}, {2, 2, 4, 4, 3}}), creases, 12);
    EXPECT_EQ(passed.kind, Kind::crease);
    std::vector<int> ends{mesh.to_vertex_handle(passed.along[0]).idx(),
                          mesh.to_vertex_handle(passed.along[1]).idx()};
    std::ranges::sort(ends);
    EXPECT_EQ(ends, (std::vector{11, 13}));
    EXPECT_EQ(mesh.from_vertex_handle(passed.along[0]), VertexId(12));
    EXPECT_EQ(mesh.from_vertex_handle(passed.along[1]), VertexId(12));
    const Layout four =
        test::makeLayout(sheet, {{0, 0, 2, 2, 0}, {2, 0, 4, 2, 0}, {0, 2, 2, 4, 0}, {2, 2, 4, 4, 0}});
    EXPECT_EQ(ruleAt(mesh, four, creases, 12).kind, Kind::corner);
    EXPECT_EQ(ruleAt(mesh, four, creaseAlong(mesh, {{11, 12}, {12, 13}}), 12).kind, Kind::crease);
}

TEST(VertexRules, ABoundaryVertexOfOneQuadIsACornerAndStraightOnesAreNot) {
    const Grid sheet{3, 2, [](double i, double j) { return Point(i, j, 0); }};
    const QuadMesh mesh = test::makeMesh(sheet);
    const Layout layout = test::makeLayout(sheet, {{0, 0, 3, 2, 0}});
    const auto rules = vertexRules(mesh, layout, creasesAndBoundary(mesh, noCreases(mesh)));
    for (int k = 0; k < 12; ++k) {
        const bool isCorner = k == 0 || k == 3 || k == 8 || k == 11;
        const bool isInside = k == 5 || k == 6;
        EXPECT_EQ(rules[at(k)].kind, isCorner ? Kind::corner : isInside ? Kind::smooth : Kind::crease) << k;
    }
}

} // namespace
} // namespace qm
