#include "check/mesh/angles.h"
#include "check/mesh/vectors.h"
#include "support/polycube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace qm::test {
namespace {

using namespace check;

TEST(CheckAngles, AreZeroBesideAFaceWithoutANormal) {
    CheckedMesh mesh = plane({"xxx"});
    for (Place& point : mesh.points) {
        point[0] = std::min(point[0], 2.0); // the last square has no area
        point[2] = -point[0] - point[1];
    }
    const auto areZero = [&] {
        const Neighbourhoods around(mesh);
        return std::ranges::count(dihedralAngles(mesh, around).angle, 0) == around.edges();
    };
    EXPECT_TRUE(areZero());
    for (Place& point : mesh.points)
        std::swap(point[0], point[1]); // turns the plane over: all components of its normal are negative
    EXPECT_TRUE(areZero());
}

} // namespace
} // namespace qm::test
