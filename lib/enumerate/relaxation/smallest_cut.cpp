#include "enumerate/relaxation/smallest_cut.h"

#include "base/infinity.h"

#include <algorithm>

namespace qm {
namespace {

constexpr double rounding = 1e-9; // for sums of capacities around 1

} // namespace

void SmallestCut::addEdge(std::size_t from, std::size_t to, double capacity) {
    edgesOf_[from].push_back(edges_.size());
    edges_.push_back({to, capacity});
    edgesOf_[to].push_back(edges_.size());
    edges_.push_back({from, 0});
}

void SmallestCut::find(std::size_t source, std::size_t sink) {
    for (findLevels(source); levels_[sink] >= 0; findLevels(source)) {
        next_.assign(edgesOf_.size(), 0);
        while (push(source, sink, infinity) > 0) {
        }
    }
}

void SmallestCut::findLevels(std::size_t source) {
    levels_.assign(edgesOf_.size(), -1);
    levels_[source] = 0;
    std::vector<std::size_t> reached{source};
    for (std::size_t k = 0; k < reached.size(); ++k)
        for (const std::size_t id : edgesOf_[reached[k]]) {
            const Edge& edge = edges_[id];
            if (edge.left <= rounding || levels_[edge.to] >= 0) continue;
            levels_[edge.to] = levels_[reached[k]] + 1;
            reached.push_back(edge.to);
        }
}

/// Pushes flow along edges to the next level. The recursion is as deep as there are levels, which are few.
double SmallestCut::push(std::size_t node, std::size_t sink, double max) {
    if (node == sink) return max;
    for (std::size_t& k = next_[node]; k < edgesOf_[node].size(); ++k) {
        const std::size_t id = edgesOf_[node][k];
        if (edges_[id].left <= rounding || levels_[edges_[id].to] != levels_[node] + 1) continue;
        const double pushed = push(edges_[id].to, sink, std::min(max, edges_[id].left));
        if (pushed <= 0) continue;
        edges_[id].left -= pushed;
        edges_[id ^ 1U].left += pushed;
        return pushed;
    }
    return 0;
}

} // namespace qm
