// Base complexes and numbers of graphs of real meshes, known from other sources.
#include "support/brute_force.h"
#include "support/shared_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace qm::test {
namespace {

using namespace check;

struct Complex {
    const char* name;
    int extraordinaryVertices;
    std::size_t ordinaryJunctions;
    int selfCrossing;
};

struct Graphs {
    const char* name;
    std::size_t graphs;
    std::uint64_t vectors; ///< valid ones; vectors that differ only in who walks an uncrossed line count once
    int uncrossedLines;
    double cost; ///< of the cheapest graph
};

void PrintTo(const Complex& known, std::ostream* out) {
    *out << known.name;
}
void PrintTo(const Graphs& known, std::ostream* out) {
    *out << known.name;
}

template <class Known> class OfMesh : public ::testing::TestWithParam<Known> {
protected:
    void SetUp() override {
        mesh = sharedMesh(std::string("dev/") + this->GetParam().name);
        if (!mesh) GTEST_SKIP() << "the mesh is not here";
    }
    std::optional<CheckedMesh> mesh;
};

std::string testName(std::string name) {
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

class KnownComplex : public OfMesh<Complex> {};

TEST_P(KnownComplex, IsFound) {
    const Neighbourhoods around(*mesh);
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

INSTANTIATE_TEST_SUITE_P(
    Check, KnownComplex,
    ::testing::Values(Complex{"cube6.off", 8, 0, 0}, Complex{"yas_island.off", 4, 0, 0},
                      Complex{"gitter.off", 12, 0, 0}, Complex{"Cpadded.obj", 16, 8, 0},
                      Complex{"fandisk_qex.obj", 28, 220, 6}, Complex{"awkward_valid.obj", 28, 220, 6},
                      Complex{"neon_side.off", 33, 233, 1}, Complex{"duck_miq_8.obj", 28, 241, 6},
                      Complex{"botijo_miq.obj", 74, 403, 4}, Complex{"rockerarm_qf_1k.obj", 32, 562, 4},
                      Complex{"beetle_qf_5k.obj", 93, 813, 0}, Complex{"circle_in_square.obj", 30, 262, 0},
                      Complex{"car_opensubdiv.obj", 346, 360, 0}, Complex{"torus_regular.obj", 0, 0, 0}),
    [](const auto& each) { return testName(each.param.name); });

class KnownGraphs : public OfMesh<Graphs> {};

TEST_P(KnownGraphs, AreAllFound) {
    const Neighbourhoods around(*mesh);
    const EdgeCosts costs = edgeCosts(dihedralAngles(*mesh, around), 0.4, 0.2);
    const BruteForce all = bruteForce(around, traceLines(around, {}).front(), costs);
    EXPECT_EQ(all.graphs.size(), GetParam().graphs);
    EXPECT_EQ(all.vectors, GetParam().vectors);
    EXPECT_EQ(all.uncrossedLines, GetParam().uncrossedLines);
    const auto cheapest =
        std::min_element(all.graphs.begin(), all.graphs.end(),
                         [](const auto& a, const auto& b) { return a.second.cost < b.second.cost; });
    EXPECT_NEAR(cheapest->second.cost, GetParam().cost, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Check, KnownGraphs,
                         ::testing::Values(Graphs{"cube6.off", 1, 1, 12, -18.849556},
                                           Graphs{"gitter.off", 1, 1, 8, -52.367289},
                                           Graphs{"block_skel.obj", 1, 1, 56, -79.188544},
                                           Graphs{"rod.obj", 7, 74, 24, -143.680898},
                                           Graphs{"duck_miq_28.obj", 8, 952, 15, -46.093969},
                                           Graphs{"Cpadded.obj", 28, 21386, 18, -40.007942},
                                           Graphs{"cactus.obj", 49, 5476, 36, -210.594046}),
                         [](const auto& each) { return testName(each.param.name); });

} // namespace
} // namespace qm::test
