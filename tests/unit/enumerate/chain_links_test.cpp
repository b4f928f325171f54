#include "enumerate/window/chain_links.h"
#include "support/random_problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace qm {
namespace {

/// A cluster by its definition: of all chains that cross it, the one with the most crossings in proportion to
/// its length is next.
/// \param counts  the variables whose crossings and length count
std::vector<ChainId> clusterByDefinition(const Problem& problem, const Assignment& counts, ChainId start,
                                         std::size_t variables, const IdVector<ChainId, double>& weights) {
    IdVector<VariableId, ChainId> chainOf(problem.domains.size());
    IdVector<ChainId, int> lengths(problem.chains.size(), 0);
    for (const ChainId chain : problem.chains.ids())
        for (const VariableId variable : problem.chains[chain].variables())
            if (counts[variable] == 1) {
                chainOf[variable] = chain;
                ++lengths[chain];
            }
    std::vector<ChainId> members{start};
    auto size = static_cast<std::size_t>(lengths[start]);
    while (size < variables) {
        std::map<ChainId, int> crossings;
        for (const Crossing& crossing : problem.crossings)
            for (const std::size_t side : {0U, 1U})
                for (const VariableId v : {crossing.sides[side].before, crossing.sides[side].after})
                    for (const VariableId w :
                         {crossing.sides[1 - side].before, crossing.sides[1 - side].after})
                        if (chainOf[v].valid() && chainOf[w].valid() &&
                            std::ranges::count(members, chainOf[v]) &&
                            !std::ranges::count(members, chainOf[w]))
                            ++crossings[chainOf[w]];
        if (crossings.empty()) break;
        const auto closeness = [&](const auto& entry) {
            return entry.second * weights[entry.first] / lengths[entry.first];
        };
        members.push_back(std::ranges::max_element(crossings, {}, closeness)->first);
        size += static_cast<std::size_t>(lengths[members.back()]);
    }
    return members;
}

TEST(ChainLinks, ClustersGrowByTheClosestChain) {
    int compared = 0, ofTracks = 0;
    for (unsigned number = 0; number < 60; ++number) {
        const auto drawn = test::randomProblem(number);
        if (!drawn || !drawn->problem) continue;
        const Problem& problem = *drawn->problem;
        const ChainLinks links(problem);
        const Assignment everything(problem.domains.size(), 1);
        std::mt19937 random(number);
        IdVector<ChainId, double> weights(problem.chains.size(), 1);
        if (number % 2 == 0)
            std::ranges::generate(weights,
                                  [&] { return std::uniform_real_distribution<double>(0, 2)(random); });
        for (const ChainId chain : problem.chains.ids())
            for (const std::size_t variables : {1U, 8U, 1000U}) {
                const auto cluster = links.cluster(chain, variables, weights);
                EXPECT_EQ(cluster, clusterByDefinition(problem, everything, chain, variables, weights))
                    << number;
                compared += cluster.size() > 3 ? 1 : 0;
                if (drawn->graphs.empty()) continue;
                const Assignment& graph = drawn->graphs.front();
                const auto tracks = ChainLinks(problem, graph).cluster(chain, variables, weights);
                EXPECT_EQ(tracks, clusterByDefinition(problem, graph, chain, variables, weights)) << number;
                ofTracks += tracks.size() > 2 && tracks != cluster ? 1 : 0;
            }
    }
    EXPECT_GT(compared, 50);
    EXPECT_GT(ofTracks, 50);
}

} // namespace
} // namespace qm
