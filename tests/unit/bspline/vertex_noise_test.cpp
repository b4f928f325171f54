#include "bspline/reference/scan/triangle_surface.h"
#include "mesh/bounding_box.h"
#include "shape/scan.h"
#include "shape/shape.h"

#include <gtest/gtest.h>

namespace qm {
namespace {

class NoiseOfVertices : public ::testing::TestWithParam<const char*> {};

TEST_P(NoiseOfVertices, IsFoundHoweverCoarseTheScan) {
    for (const double triangles : {10'000.0, 60'000.0})
        for (const double share : {0.0002, 0.0005}) {
            Triangles scan = makeScan(GetParam(), triangles);
            const double deviation = share * boundingBoxOf(scan.points).diagonal();
            addNoise(scan, deviation, 5);
            const auto found = TriangleSurface(scan).noise();
            ASSERT_TRUE(found) << triangles << " " << share;
            EXPECT_NEAR(*found, deviation, 0.15 * deviation) << triangles << " " << share;
        }
}

TEST_P(NoiseOfVertices, IsNearlyNoneWithoutNoise) {
    const Triangles scan = makeScan(GetParam(), 60'000);
    const auto found = TriangleSurface(scan).noise();
    ASSERT_TRUE(found);
    EXPECT_LT(*found, 2e-5 * boundingBoxOf(scan.points).diagonal());
}

INSTANTIATE_TEST_SUITE_P(Parts, NoiseOfVertices,
                         ::testing::Values("sphere", "torus", "block", "plate", "tube"));

TEST(NoiseOfVertices, FacetsDoNotTellIt) {
    const Triangles cube{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
        {{0, 2, 1},
         {0, 3, 2},
         {4, 5, 6},
         {4, 6, 7},
         {0, 1, 5},
         {0, 5, 4},
         {2, 3, 7},
         {2, 7, 6},
         {0, 4, 7},
         {0, 7, 3},
         {1, 2, 6},
         {1, 6, 5}}};
    EXPECT_FALSE(TriangleSurface(cube).noise());
}

} // namespace
} // namespace qm
