#include "enumerate/window/chain_links.h"

#include <map>
#include <unordered_set>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

ChainLinks::ChainLinks(const Problem& problem)
    : neighbours_(problem.chains.size()), crossings_(problem.chains.size()) {
    std::vector<int> chainOf(problem.domains.size(), -1);
    for (std::size_t c = 0; c < problem.chains.size(); ++c) {
        lengths_.push_back(problem.chains[c].count);
        for (int k = 0; k < problem.chains[c].count; ++k)
            chainOf[at(problem.chains[c].first + k)] = static_cast<int>(c);
    }
    std::vector<std::map<int, int>> links(problem.chains.size());
    for (const Crossing& crossing : problem.crossings)
        for (const int v : {crossing.sides[0].before, crossing.sides[0].after})
            for (const int w : {crossing.sides[1].before, crossing.sides[1].after}) {
                const int a = chainOf[at(v)], b = chainOf[at(w)];
                if (a < 0 || b < 0) continue;
                ++links[at(a)][b];
                ++links[at(b)][a];
            }
    for (std::size_t c = 0; c < links.size(); ++c)
        for (const auto& [neighbour, count] : links[c]) {
            neighbours_[c].push_back(neighbour);
            crossings_[c].push_back(count);
        }
}

std::vector<int> ChainLinks::cluster(int start, std::size_t variables,
                                     const std::vector<double>& weights) const {
    std::vector<int> members;
    std::map<int, int> waiting{{start, 1}};
    std::unordered_set<int> taken;
    for (std::size_t size = 0; size < variables && !waiting.empty();) {
        const auto closeness = [&](const auto& entry) {
            return entry.second * weights[at(entry.first)] / lengths_[at(entry.first)];
        };
        const auto next = std::ranges::max_element(waiting, {}, closeness);
        const int chain = next->first;
        waiting.erase(next);
        taken.insert(chain);
        members.push_back(chain);
        size += at(lengths_[at(chain)]);
        for (std::size_t k = 0; k < neighbours_[at(chain)].size(); ++k)
            if (const int neighbour = neighbours_[at(chain)][k]; !taken.contains(neighbour))
                waiting[neighbour] += crossings_[at(chain)][k];
    }
    return members;
}

} // namespace qm
