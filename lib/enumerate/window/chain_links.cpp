#include "enumerate/window/chain_links.h"

#include "base/at.h"

#include <map>
#include <queue>
#include <unordered_map>
#include <utility>

namespace qm {
namespace {

/// A chain that may join a cluster.
struct Candidate {
    double closeness;
    ChainId chain;

    bool operator<(const Candidate& other) const {
        return closeness != other.closeness ? closeness < other.closeness : chain > other.chain;
    }
};

} // namespace

ChainLinks::ChainLinks(const Problem& problem)
    : neighbours_(problem.chains.size()), crossings_(problem.chains.size()) {
    IdVector<VariableId, ChainId> chainOf(problem.domains.size());
    for (const ChainId chain : problem.chains.ids()) {
        lengths_.push_back(problem.chains[chain].count);
        for (const VariableId variable : problem.chains[chain].variables())
            chainOf[variable] = chain;
    }
    IdVector<ChainId, std::map<ChainId, int>> links(problem.chains.size());
    for (const Crossing& crossing : problem.crossings)
        for (const VariableId v : {crossing.sides[0].before, crossing.sides[0].after})
            for (const VariableId w : {crossing.sides[1].before, crossing.sides[1].after}) {
                const ChainId a = chainOf[v], b = chainOf[w];
                if (!a.valid() || !b.valid()) continue;
                ++links[a][b];
                ++links[b][a];
            }
    for (const ChainId c : links.ids())
        for (const auto& [neighbour, count] : links[c]) {
            neighbours_[c].push_back(neighbour);
            crossings_[c].push_back(count);
        }
}

std::vector<ChainId> ChainLinks::cluster(ChainId start, std::size_t variables,
                                         const IdVector<ChainId, double>& weights) const {
    constexpr int member = -1;
    std::vector<ChainId> members;
    std::unordered_map<ChainId, int> crossings; // of every waiting chain with the cluster; or `member`
    std::priority_queue<Candidate> waiting;
    const auto addCrossings = [&](ChainId chain, int count) {
        int& sum = crossings[chain];
        if (sum == member) return;
        sum += count;
        waiting.push({sum * weights[chain] / lengths_[chain], chain});
    };
    addCrossings(start, 1);
    for (std::size_t size = 0; size < variables && !waiting.empty();) {
        const ChainId chain = waiting.top().chain;
        waiting.pop();
        if (std::exchange(crossings[chain], member) == member) continue; // it came closer, and was taken then
        members.push_back(chain);
        size += at(lengths_[chain]);
        for (std::size_t k = 0; k < neighbours_[chain].size(); ++k)
            addCrossings(neighbours_[chain][k], crossings_[chain][k]);
    }
    return members;
}

} // namespace qm
