#include "mesh/triangles/triangles.h"
#include "remesh/mismatch.h"

#include <gtest/gtest.h>

namespace qm {
namespace {

/// A plate of 10 x `rows` squares of triangles.
Triangles plate(int rows) {
    Triangles scan;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= 10; ++i)
            scan.points.emplace_back(i, j, 0);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < 10; ++i) {
            const int corner = 11 * j + i;
            scan.faces.push_back({corner, corner + 1, corner + 12});
            scan.faces.push_back({corner, corner + 12, corner + 11});
        }
    return scan;
}

/// The same of 10 x 10 quads.
QuadMesh quads() {
    QuadMesh mesh;
    for (int j = 0; j <= 10; ++j)
        for (int i = 0; i <= 10; ++i)
            mesh.add_vertex({double(i), double(j), 0});
    for (int j = 0; j < 10; ++j)
        for (int i = 0; i < 10; ++i) {
            const VertexId corner(11 * j + i);
            mesh.add_face(corner, VertexId(corner.idx() + 1), VertexId(corner.idx() + 12),
                          VertexId(corner.idx() + 11));
        }
    return mesh;
}

TEST(Mismatch, IsNoneWhereQuadsLieOnTheScan) {
    const Mismatch found = mismatchOf(quads(), plate(10), 2);
    EXPECT_EQ(found.missing, 0);
    EXPECT_EQ(found.strayed, 0);
    EXPECT_EQ(mismatchOf(quads(), plate(11), 2).missing, 0) << "within two edges";
}

TEST(Mismatch, ToldIsWhatQuadsLeaveOut) {
    const Mismatch found = mismatchOf(quads(), plate(20), 2);
    EXPECT_NEAR(found.missing, 0.4, 0.03);
    EXPECT_NEAR(found.missingDistance, 10, 1);
    EXPECT_GT(found.missingAt[1], 19);
    EXPECT_EQ(found.strayed, 0);
}

TEST(Mismatch, ToldIsWhereQuadsStray) {
    QuadMesh mesh = quads();
    mesh.set_point(VertexId(60), {5, 5, 4});
    const Mismatch found = mismatchOf(mesh, plate(10), 2);
    EXPECT_EQ(found.missing, 0);
    EXPECT_NEAR(found.strayed, 4, 1e-12);
    EXPECT_EQ(found.strayedAt, Point(5, 5, 4));
}

} // namespace
} // namespace qm
