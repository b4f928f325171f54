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

/// The chain of every variable that counts.
template <class Counts> IdVector<VariableId, ChainId> chainsOf(const Problem& problem, const Counts& counts) {
    IdVector<VariableId, ChainId> chainOf(problem.domains.size());
    for (const ChainId chain : problem.chains.ids())
        for (const VariableId variable : problem.chains[chain].variables())
            if (counts(variable)) chainOf[variable] = chain;
    return chainOf;
}

} // namespace

ChainLinks::ChainLinks(const Problem& problem)
    : ChainLinks(problem, chainsOf(problem, [](VariableId) { return true; })) {}

ChainLinks::ChainLinks(const Problem& problem, const Assignment& graph)
    : ChainLinks(problem, chainsOf(problem, [&](VariableId variable) { return graph[variable] == 1; })) {}

/// \param chainOf  of every variable whose crossings count
ChainLinks::ChainLinks(const Problem& problem, const IdVector<VariableId, ChainId>& chainOf)
    : lengths_(problem.chains.size(), 0), neighbours_(problem.chains.size()),
      crossings_(problem.chains.size()) {
    for (const ChainId chain : chainOf)
        if (chain.valid()) ++lengths_[chain];
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
    waiting.push({0, start});
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
