// Base complexes and counts of graphs of real meshes, known from elsewhere.
#include "support/brute_force.h"
#include "support/shared_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace qm::testing {
namespace {

using namespace check;

struct Known {
    const char* name;
    int extraordinaryVertices;
    std::size_t ordinaryJunctions;
    int selfCrossing;
    std::size_t graphs;    ///< 0 where they are too many to try all
    std::uint64_t vectors; ///< valid, without those that differ in who walks an uncrossed line
    int uncrossedLines;
    double cost;
};

void PrintTo(const Known& known, std::ostream* out) {
    *out << known.name;
}

class KnownMesh : public ::testing::TestWithParam<Known> {
protected:
    void SetUp() override {
        mesh_ = sharedMesh(std::string("dev/") + GetParam().name);
        if (!mesh_) GTEST_SKIP() << "the mesh is not here";
    }
    std::optional<CheckedMesh> mesh_;
};

TEST_P(KnownMesh, HasItsBaseComplex) {
    const Neighbourhoods around(*mesh_);
    const LineNetwork network = traceLines(around, {}).front();
    int extraordinary = 0;
    for (int v = 0; v < around.vertices(); ++v)
        extraordinary += !around.regular(v);
    const auto crossing = std::count_if(network.ways.begin(), network.ways.end(),
                                        [](const Way& way) { return way.selfCrossing(); });
    EXPECT_EQ(extraordinary, GetParam().extraordinaryVertices);
    EXPECT_EQ(network.ordinaryJunctions, GetParam().ordinaryJunctions);
    EXPECT_EQ(crossing, GetParam().selfCrossing);
}

TEST_P(KnownMesh, HasItsGraphs) {
    if (GetParam().graphs == 0) GTEST_SKIP() << "too many";
    const Neighbourhoods around(*mesh_);
    const EdgeCosts costs = edgeCosts(dihedralAngles(*mesh_, around), 0.4, 0.2);
    const BruteForce all = bruteForce(around, traceLines(around, {}).front(), costs);
    EXPECT_EQ(all.graphs.size(), GetParam().graphs);
    EXPECT_EQ(all.vectors, GetParam().vectors);
    EXPECT_EQ(all.uncrossedLines, GetParam().uncrossedLines);
    const auto cheapest =
        std::min_element(all.graphs.begin(), all.graphs.end(),
                         [](const auto& a, const auto& b) { return a.second.cost < b.second.cost; });
    EXPECT_NEAR(cheapest->second.cost, GetParam().cost, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Check, KnownMesh,
                         ::testing::Values(Known{"cube6.off", 8, 0, 0, 1, 1, 12, -18.849556},
                                           Known{"yas_island.off", 4, 0, 0, 1, 1, 0, 2.444242},
                                           Known{"gitter.off", 12, 0, 0, 1, 1, 8, -52.367289},
                                           Known{"block_skel.obj", 24, 0, 0, 1, 1, 56, -79.188544},
                                           Known{"rod.obj", 12, 4, 0, 7, 74, 24, -143.680898},
                                           Known{"duck_miq_28.obj", 13, 5, 0, 8, 952, 15, -46.093969},
                                           Known{"Cpadded.obj", 16, 8, 0, 28, 21386, 18, -40.007942},
                                           Known{"cactus.obj", 24, 8, 0, 49, 5476, 36, -210.594046},
                                           Known{"fandisk_qex.obj", 28, 220, 6, 0, 0, 0, 0},
                                           Known{"awkward_valid.obj", 28, 220, 6, 0, 0, 0, 0},
                                           Known{"neon_side.off", 33, 233, 1, 0, 0, 0, 0},
                                           Known{"duck_miq_8.obj", 28, 241, 6, 0, 0, 0, 0},
                                           Known{"botijo_miq.obj", 74, 403, 4, 0, 0, 0, 0},
                                           Known{"rockerarm_qf_1k.obj", 32, 562, 4, 0, 0, 0, 0},
                                           Known{"beetle_qf_5k.obj", 93, 813, 0, 0, 0, 0, 0},
                                           Known{"circle_in_square.obj", 30, 262, 0, 0, 0, 0, 0},
                                           Known{"car_opensubdiv.obj", 346, 360, 0, 0, 0, 0, 0}),
                         [](const auto& each) {
                             std::string name = each.param.name;
                             std::replace_if(
                                 name.begin(), name.end(), [](char c) { return c == '.'; }, '_');
                             return name;
                         });

} // namespace
} // namespace qm::testing
