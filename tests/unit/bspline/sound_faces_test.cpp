#include "base/at.h"
#include "bspline/reference/lattice/sound_faces.h"
#include "support/grid_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace qm {
namespace {

/// Six columns and one row; the plane turns by an angle after the third column.
QuadMesh bentStrip(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return test::makeMesh({6, 1, [angle](double i, double j) {
                               const double beyond = std::max(i - 3, 0.0);
                               return Point(std::min(i, 3.0) + beyond * std::cos(angle), j,
                                            beyond * std::sin(angle));
                           }});
}

/// Of the strip above, with a crease where it turns or without one.
std::vector<bool> uprightInStrip(double degrees, bool hasCrease) {
    const QuadMesh mesh = bentStrip(degrees);
    std::vector<bool> sharp(mesh.n_edges());
    constexpr int below = 3, above = 3 + 7; // the vertices of the middle
    sharp[at(mesh.edge_handle(mesh.find_halfedge(VertexId(below), VertexId(above))))] = hasCrease;
    return uprightFaces(mesh, sharp, 1);
}

TEST(UprightFaces, MayTurnFarAcrossCreasesOnly) {
    const std::vector<bool> all(6, true);
    const std::vector<bool> butTheMiddle{true, true, false, false, true, true};
    EXPECT_EQ(uprightInStrip(80, false), all);
    EXPECT_EQ(uprightInStrip(100, false), butTheMiddle);
    EXPECT_EQ(uprightInStrip(100, true), all);
    EXPECT_EQ(uprightInStrip(130, true), butTheMiddle);
}

/// Five by five squares whose vertex (2, 2) lies elsewhere.
QuadMesh movedVertex(const Point& place) {
    return test::makeMesh(
        {5, 5, [place](double i, double j) { return i == 2 && j == 2 ? place : Point(i, j, 0); }});
}

TEST(UprightFaces, AreFoldedNeitherThemselvesNorBesideQuadsWithoutArea) {
    const auto notUpright = [](const Point& place) {
        const QuadMesh mesh = movedVertex(place);
        const std::vector<bool> isUpright = uprightFaces(mesh, std::vector<bool>(mesh.n_edges()), 1);
        std::vector<int> faces;
        for (int face = 0; face < 25; ++face)
            if (!isUpright[at(face)]) faces.push_back(face);
        return faces;
    };
    EXPECT_EQ(notUpright({2.2, 1.9, 0}), std::vector<int>{});
    // Beyond the diagonal of the quad in column and row 2, which alone is folded.
    EXPECT_EQ(notUpright({2.6, 2.6, 0}), std::vector<int>{12});
    // In its opposite corner, up to rounding: it has no area, and all quads around it are touched by that.
    EXPECT_EQ(notUpright({3, 3, 1e-9}), (std::vector<int>{6, 7, 8, 11, 12, 13, 16, 17, 18}));
}

TEST(Shrunk, TakesOutRingsAroundTheOthers) {
    const QuadMesh mesh = test::makeMesh({7, 1, [](double i, double j) { return Point(i, j, 0); }});
    const std::vector<bool> faces{false, true, true, true, true, true, true};
    EXPECT_EQ(shrunk(mesh, faces, 0), faces);
    EXPECT_EQ(shrunk(mesh, faces, 2), (std::vector<bool>{false, false, false, true, true, true, true}));
}

} // namespace
} // namespace qm
