#include "enumerate/diagram/count_and_draw.h"

#include "enumerate/diagram/ranked_graphs.h"

#include <algorithm>
#include <limits>
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

class CostlyWays {
public:
    CostlyWays(const Diagram& diagram, const Control& control)
        : diagram_(diagram), control_(control), ways_(countWays(diagram)), cheapest_(cheapestWays(diagram)),
          dearest_(diagram.nodes.size(), -std::numeric_limits<double>::infinity()) {
        dearest_[Diagram::end] = 0;
        for (std::size_t id = Diagram::end + 1; id < dearest_.size(); ++id) {
            const Diagram::Node& node = diagram.nodes[id];
            dearest_[id] = std::max(node.cost + dearest_[node.in], dearest_[node.out]);
        }
    }

    std::optional<BigCount> count(double maxCost) {
        countFrom(diagram_.root, maxCost - diagram_.fixedCost);
        return stopped_ ? std::nullopt : std::optional(sum_);
    }

private:
    void countFrom(Diagram::NodeId id, double left) {
        if (stopped_ || cheapest_[id] > left) return;
        if (dearest_[id] <= left) {
            sum_ += ways_[id];
            return;
        }
        stopped_ = ++steps_ % 4096 == 0 && control_.stopRequested();
        const Diagram::Node& node = diagram_.nodes[id];
        countFrom(node.in, left - node.cost);
        countFrom(node.out, left);
    }

    const Diagram& diagram_;
    const Control& control_;
    std::vector<BigCount> ways_;
    std::vector<double> cheapest_;
    std::vector<double> dearest_;
    BigCount sum_ = 0;
    std::size_t steps_ = 0;
    bool stopped_ = false;
};

} // namespace

std::vector<BigCount> countWays(const Diagram& diagram) {
    std::vector<BigCount> ways(diagram.nodes.size());
    ways[Diagram::end] = 1;
    for (std::size_t node = Diagram::end + 1; node < ways.size(); ++node)
        ways[node] = ways[diagram.nodes[node].in] + ways[diagram.nodes[node].out];
    return ways;
}

std::optional<BigCount> countUpTo(const Diagram& diagram, double maxCost, const Control& control) {
    return CostlyWays(diagram, control).count(maxCost);
}

Assignment graphOfRank(const Diagram& diagram, const std::vector<BigCount>& ways, BigCount rank) {
    Assignment graph = diagram.fixed;
    for (Diagram::NodeId id = diagram.root; id > Diagram::end;) {
        const Diagram::Node& node = diagram.nodes[id];
        const bool in = rank < ways[node.in];
        if (!in) rank -= ways[node.in];
        if (node.variable.valid()) graph[node.variable] = in ? 1 : 0;
        id = in ? node.in : node.out;
    }
    return graph;
}

std::vector<Assignment> drawGraphs(const Diagram& diagram, std::size_t count, std::size_t seed) {
    const std::vector<BigCount> ways = countWays(diagram);
    std::mt19937_64 random(seed);
    std::vector<Assignment> graphs;
    while (ways[diagram.root] > 0 && graphs.size() < count)
        graphs.push_back(graphOfRank(diagram, ways, drawBelow(ways[diagram.root], random)));
    return graphs;
}

} // namespace qm
