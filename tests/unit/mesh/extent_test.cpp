#include "mesh/extent.h"
#include "support/message_of.h"

#include <gtest/gtest.h>

#include <string>

namespace qm {
namespace {

/// Of a square quad; empty if its size and place are accepted.
std::string refusal(double origin, double side) {
    QuadMesh mesh;
    const auto add = [&](double x, double y) { return mesh.add_vertex({origin + x, y, 0}); };
    mesh.add_face(add(0, 0), add(side, 0), add(side, side), add(0, side));
    return test::messageOf([&] { verifyExtent(boundingBox(mesh)); });
}

TEST(Extent, IsNeitherTooSmallNorTooLarge) {
    EXPECT_EQ(refusal(0, 1e-29), "");
    EXPECT_EQ(refusal(0, 1e29), "");
    EXPECT_EQ(refusal(0, 1e-40),
              "it is 1e-40 across, with coordinates up to 1e-40: too small to compute with. Scale the model");
    EXPECT_EQ(refusal(0, 1e40),
              "it is 1e+40 across, with coordinates up to 1e+40: too large to compute with. Scale the model");
    EXPECT_EQ(refusal(5, 0), "all vertices lie at one place. Is it another format?");
}

TEST(Extent, IsNotFarFromTheOrigin) {
    EXPECT_EQ(refusal(3'000'000, 1), "");
    EXPECT_EQ(refusal(30'000'000, 1),
              "it is 1 across and 30000001 away from the origin, where coordinates have "
              "too few digits. Move the model to the origin");
}

} // namespace
} // namespace qm
