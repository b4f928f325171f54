// The limits of work of searches, and that a search by windows repeats none; what windows achieve is tested
// in tests/property.
#include "enumerate/optimum/optimum.h"
#include "enumerate/paper/plain_graph.h"
#include "enumerate/sub_mesh/search_space.h"
#include "enumerate/window/chain_links.h"
#include "enumerate/window/window_search.h"
#include "layout/tracks.h"
#include "shape/shape.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace qm::test {
namespace {

/// A mesh with random costs, and its plain graph.
struct Sample {
    QuadMesh mesh;
    BaseComplex complex;
    std::vector<double> costs;
    SearchSpace space;
    PresentArcs plain;

    explicit Sample(unsigned seed)
        : mesh(makeShape("random", {1, 0, seed, 80})), complex(buildBaseComplex(mesh)),
          costs(drawCosts(seed)), space(makeSearchSpace(mesh, complex, {costs}, {}, {})),
          plain(
              presentArcs({mesh, complex, space.graph}, plainMotorcycleGraph(mesh, complex, costs).tracks)) {}

    [[nodiscard]] std::vector<double> drawCosts(unsigned seed) const {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> cost(-1, 1);
        std::vector<double> drawn(mesh.n_edges());
        std::ranges::generate(drawn, [&] { return cost(random); });
        return drawn;
    }

    [[nodiscard]] ProblemInput input() const { return {space.graph, space.arcCosts, {}, {}, {}, {}}; }
};

/// The largest windows that the chains of a problem grow to, each once.
std::set<std::vector<ChainId>> largestWindows(const Problem& problem) {
    const ChainLinks links(problem);
    const IdVector<ChainId, double> weights(problem.chains.size(), 1);
    std::set<std::vector<ChainId>> windows;
    for (const ChainId chain : problem.chains.ids()) {
        std::vector<ChainId> chains = links.cluster(chain, problem.domains.size(), weights);
        std::ranges::sort(chains);
        windows.insert(chains);
    }
    return windows;
}

TEST(WindowSearch, SearchesAWindowOnceHoweverManyChainsGrowToIt) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        const Sample sample(seed);
        const ProblemInput input = sample.input();
        const Problem problem = makeProblem(input);
        WindowOptions options;
        options.minVariables = problem.domains.size();
        const WindowResult result = improveByWindows(input, sample.plain, options);
        // Those that change together with others may have to be searched again.
        const std::size_t atMost = largestWindows(problem).size() + result.improvements;
        ASSERT_LT(atMost, problem.chains.size());
        EXPECT_LE(result.windows, atMost) << "seed " << seed;
        EXPECT_GT(result.improvements, 0U);
    }
}

TEST(WindowSearch, EndsAtALimitOfWorkWhateverTheNumberOfThreads) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        const Sample sample(seed);
        const ProblemInput input = sample.input();
        WindowOptions options;
        options.maxWork = 1;
        const WindowResult limited = improveByWindows(input, sample.plain, options);
        EXPECT_GT(limited.windows, 0U);
        EXPECT_LT(2 * limited.windows, improveByWindows(input, sample.plain, {}).windows) << "seed " << seed;
        EXPECT_TRUE(isMotorcycleGraph(sample.space.graph, limited.present));
        Control control;
        control.jobs = 3;
        EXPECT_EQ(improveByWindows(input, sample.plain, options, control).present, limited.present);
    }
}

TEST(Optimum, EndsAtALimitOfWorkWithTheBestSoFar) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        const Sample sample(seed);
        const Problem problem = makeProblem(sample.input());
        OptimumOptions options;
        options.start = assignmentOf(problem, sample.plain);
        options.nodes = 1000; // so few that no decision diagram is tried
        const OptimumResult full = findOptimum(problem, options);
        ASSERT_TRUE(full.complete);
        options.work = full.work / 3;
        const OptimumResult limited = findOptimum(problem, options);
        EXPECT_FALSE(limited.complete) << "seed " << seed;
        EXPECT_LE(limited.work, full.work);
        ASSERT_EQ(limited.graphs.size(), 1U);
        EXPECT_LE(limited.lowerBound, full.lowerBound + 1e-6);
        EXPECT_LE(costOf(problem, full.graphs.front()), costOf(problem, limited.graphs.front()) + 1e-6);
        EXPECT_LE(costOf(problem, limited.graphs.front()), costOf(problem, *options.start) + 1e-6);
    }
}

} // namespace
} // namespace qm::test
