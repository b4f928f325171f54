#include "base/error.h"
#include "check/mesh/neighbourhoods.h"
#include "support/polycube.h"
#include "support/true_models.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace qm::test {
namespace {

using namespace check;

TEST(Neighbourhoods, RefusesWhatIsNoManifold) {
    CheckedMesh bowTie = plane({"x.", ".x"});
    EXPECT_THROW(Neighbourhoods{bowTie}, Error);
    CheckedMesh flipped = plane({"xx"});
    std::reverse(flipped.quads[1].begin(), flipped.quads[1].end());
    EXPECT_THROW(Neighbourhoods{flipped}, Error);
    CheckedMesh fin = plane({"xx"});
    fin.points.push_back({1, 0, 1});
    fin.points.push_back({1, 1, 1});
    fin.quads.push_back({fin.quads[0][1], 6, 7, fin.quads[0][2]});
    EXPECT_THROW(Neighbourhoods{fin}, Error);
    CheckedMesh repeated = plane({"x"});
    repeated.quads[0][1] = repeated.quads[0][0];
    EXPECT_THROW(Neighbourhoods{repeated}, Error);
    CheckedMesh outside = plane({"x"});
    outside.quads[0][1] = 4;
    EXPECT_THROW(Neighbourhoods{outside}, Error);
}

TEST(Neighbourhoods, KnowsBothSidesOfEveryStep) {
    for (const CheckedMesh& mesh : {corner(), twoHoles(), torus(5, 4), tube(5, 3)}) {
        const Neighbourhoods around(mesh);
        for (int step = 0; step < around.steps(); ++step) {
            EXPECT_EQ(around.back(around.back(step)), step);
            EXPECT_EQ(around.edge(around.back(step)), around.edge(step));
            EXPECT_EQ(around.stepBetween(around.from(step), around.to(step)), step);
            EXPECT_NE(around.from(step), around.to(step));
        }
        EXPECT_EQ(around.steps(), 2 * around.edges());
    }
}

} // namespace
} // namespace qm::test
