#include "enumerate/relaxation/acyclic_graph.h"

#include <algorithm>
#include <numeric>

namespace qm {

AcyclicGraph::AcyclicGraph(std::size_t nodes)
    : rank_(nodes), next_(nodes), previous_(nodes), seen_(nodes, 0) {
    std::iota(rank_.begin(), rank_.end(), 0U);
}

bool AcyclicGraph::add(std::size_t from, std::size_t to) {
    if (from == to) return false;
    if (rank_[from] > rank_[to]) {
        ++edge_;
        if (!collectAfter(to, from)) return false;
        collectBefore(from, to);
        reorder();
    }
    next_[from].push_back(to);
    previous_[to].push_back(from);
    return true;
}

/// \return false if the forbidden node can be reached from the first
bool AcyclicGraph::collectAfter(std::size_t first, std::size_t forbidden) {
    after_.assign(1, first);
    seen_[first] = edge_;
    for (std::size_t k = 0; k < after_.size(); ++k)
        for (const std::size_t node : next_[after_[k]]) {
            if (node == forbidden) return false;
            if (rank_[node] > rank_[forbidden] || seen_[node] == edge_) continue;
            seen_[node] = edge_;
            after_.push_back(node);
        }
    return true;
}

void AcyclicGraph::collectBefore(std::size_t last, std::size_t first) {
    before_.assign(1, last);
    seen_[last] = edge_;
    for (std::size_t k = 0; k < before_.size(); ++k)
        for (const std::size_t node : previous_[before_[k]]) {
            if (rank_[node] < rank_[first] || seen_[node] == edge_) continue;
            seen_[node] = edge_;
            before_.push_back(node);
        }
}

/// Redistributes the ranks of all collected nodes: `before_` gets the lowest, `after_` the others.
void AcyclicGraph::reorder() {
    const auto rank = [this](std::size_t node) { return rank_[node]; };
    std::ranges::sort(before_, {}, rank);
    std::ranges::sort(after_, {}, rank);
    before_.insert(before_.end(), after_.begin(), after_.end());
    std::vector<std::size_t> places;
    for (const std::size_t node : before_)
        places.push_back(rank_[node]);
    std::ranges::sort(places);
    for (std::size_t k = 0; k < places.size(); ++k)
        rank_[before_[k]] = places[k];
}

} // namespace qm
