#include "enumerate/diagram/count_and_draw.h"

#include "base/infinity.h"
#include "enumerate/diagram/cheapest_graph.h"
#include "enumerate/state/independent_parts.h"
#include "enumerate/state/search_state.h"

#include <algorithm>
#include <random>

namespace qm {
namespace {

/// A uniform number below a positive limit: draws as many bits as the limit has, until they are below it.
BigCount drawBelow(const BigCount& limit, std::mt19937_64& random) {
    constexpr unsigned wordBits = 64;
    if (limit == 1) return 0;
    const auto bits = static_cast<unsigned>(msb(BigCount(limit - 1))) + 1;
    for (;;) {
        BigCount drawn = 0;
        for (unsigned left = bits; left > 0;) {
            const unsigned now = left < wordBits ? left : wordBits;
            drawn = (drawn << now) | (random() >> (wordBits - now));
            left -= now;
        }
        if (drawn < limit) return drawn;
    }
}

class PathsUpToCost {
public:
    PathsUpToCost(const Diagram& diagram, const Control& control)
        : diagram_(diagram), control_(control), paths_(countPaths(diagram)),
          minPathCost_(cheapestPaths(diagram)), maxPathCost_(diagram.nodes.size(), -infinity) {
        maxPathCost_[Diagram::end] = 0;
        for (std::size_t id = Diagram::end + 1; id < maxPathCost_.size(); ++id) {
            const Diagram::Node& node = diagram.nodes[id];
            maxPathCost_[id] = std::max(node.cost + maxPathCost_[node.in], maxPathCost_[node.out]);
        }
    }

    std::optional<BigCount> count(double maxCost) {
        countFrom(diagram_.root, maxCost - diagram_.fixedCost);
        return stopped_ ? std::nullopt : std::optional(sum_);
    }

private:
    void countFrom(Diagram::NodeId id, double left) {
        if (stopped_ || minPathCost_[id] > left) return;
        if (maxPathCost_[id] <= left) {
            sum_ += paths_[id];
            return;
        }
        stopped_ = ++steps_ % 4096 == 0 && control_.stopRequested();
        const Diagram::Node& node = diagram_.nodes[id];
        countFrom(node.in, left - node.cost);
        countFrom(node.out, left);
    }

    const Diagram& diagram_;
    const Control& control_;
    std::vector<BigCount> paths_;
    std::vector<double> minPathCost_;
    std::vector<double> maxPathCost_;
    BigCount sum_ = 0;
    std::size_t steps_ = 0;
    bool stopped_ = false;
};

/// Counts by recursion over independent parts, for problems whose diagram would be too large.
class Counter {
public:
    Counter(const Problem& problem, const Control& control) : state_(problem), control_(control) {}

    std::optional<BigCount> run() {
        if (!state_.consistent()) return BigCount(0);
        const BigCount count = countAll(independentParts(state_));
        if (stopped_) return std::nullopt;
        return count;
    }

private:
    BigCount countAll(const std::vector<std::vector<VariableId>>& parts) {
        BigCount product = 1;
        for (const auto& part : parts) {
            product *= countPart(part);
            if (product == 0) break;
        }
        return product;
    }

    /// Sets one variable to both values in turn, and counts the rest of the part, which may fall apart.
    BigCount countPart(const std::vector<VariableId>& part) {
        stopped_ = stopped_ || control_.stopRequested(); // a step may take milliseconds
        if (stopped_) return 0;
        BigCount sum = 0;
        for (const ArcState value : {ArcState::in, ArcState::out}) {
            const SearchState::Mark mark = state_.mark();
            if (state_.assign(part.front(), value)) sum += countAll(independentParts(state_, part));
            state_.undo(mark);
        }
        return sum;
    }

    SearchState state_;
    const Control& control_;
    bool stopped_ = false;
};

} // namespace

std::optional<BigCount> countGraphs(const Problem& problem, const Control& control) {
    if (const auto diagram = buildDiagram(problem, diagramNodes, control))
        return countPaths(*diagram)[diagram->root];
    return countByParts(problem, control);
}

std::optional<BigCount> countByParts(const Problem& problem, const Control& control) {
    return Counter(problem, control).run();
}

std::vector<BigCount> countPaths(const Diagram& diagram) {
    std::vector<BigCount> paths(diagram.nodes.size());
    paths[Diagram::end] = 1;
    for (std::size_t node = Diagram::end + 1; node < paths.size(); ++node)
        paths[node] = paths[diagram.nodes[node].in] + paths[diagram.nodes[node].out];
    return paths;
}

std::optional<BigCount> countUpTo(const Diagram& diagram, double maxCost, const Control& control) {
    return PathsUpToCost(diagram, control).count(maxCost);
}

Assignment graphOfRank(const Diagram& diagram, const std::vector<BigCount>& paths, BigCount rank) {
    return graphAlong(diagram, [&](Diagram::NodeId id) {
        const BigCount& throughIn = paths[diagram.nodes[id].in];
        const bool in = rank < throughIn;
        if (!in) rank -= throughIn;
        return in;
    });
}

std::vector<Assignment> drawGraphs(const Diagram& diagram, std::size_t count, std::size_t seed) {
    const std::vector<BigCount> paths = countPaths(diagram);
    std::mt19937_64 random(seed);
    std::vector<Assignment> graphs;
    while (paths[diagram.root] > 0 && graphs.size() < count)
        graphs.push_back(graphOfRank(diagram, paths, drawBelow(paths[diagram.root], random)));
    return graphs;
}

} // namespace qm
