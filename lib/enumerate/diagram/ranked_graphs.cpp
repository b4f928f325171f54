#include "enumerate/diagram/ranked_graphs.h"

#include "base/at.h"
#include "base/infinity.h"
#include "enumerate/diagram/cheapest_graph.h"
#include "enumerate/state/incumbents.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace qm {
namespace {

/// A place where a path leaves the cheapest one: an entry of a heap of all such places ahead, with the lowest
/// extra cost on top. Heaps share the heaps of later nodes, so no heap is ever changed.
struct Detour {
    double extra = 0;
    Diagram::NodeId node = Diagram::none;
    std::uint32_t left = 0;
    std::uint32_t right = 0;
    std::uint32_t rank = 0; ///< in a leftist heap
};

class Ranking {
public:
    explicit Ranking(const Diagram& diagram)
        : diagram_(diagram), cheapest_(cheapestPaths(diagram)), heaps_(diagram.nodes.size(), unknown),
          detours_(1) {
        heaps_[Diagram::end] = 0;
    }

    /// \return false if `visit` returned false
    template <class Visit> bool run(const Visit& visit) {
        offer(cheapest_[diagram_.root], 0, -1);
        while (!open_.empty()) {
            const Path path = open_.top();
            open_.pop();
            paths_.push_back(path);
            const auto id = static_cast<std::int64_t>(paths_.size()) - 1;
            if (!visit(diagram_.fixedCost + path.cost, graphOf(id))) return false;
            const Detour& last = detours_[path.detour];
            for (const std::uint32_t other : {last.left, last.right})
                if (path.detour != 0 && other != 0)
                    offer(path.cost - last.extra + detours_[other].extra, other, path.before);
            const std::uint32_t next = heapAfter(path.detour == 0 ? diagram_.root : moreExpensive(last.node));
            if (next != 0) offer(path.cost + detours_[next].extra, next, id);
        }
        return true;
    }

private:
    static constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();

    /// A path that is the cheapest except for its detours: this one, and those of the path `before`.
    struct Path {
        double cost;
        std::uint64_t number; ///< in the order of discovery, which settles ties
        std::uint32_t detour; ///< 0 if the path has none
        std::int64_t before;
        bool operator<(const Path& other) const {
            return cost != other.cost ? cost > other.cost : number > other.number;
        }
    };

    void offer(double cost, std::uint32_t detour, std::int64_t before) {
        open_.push({cost, offered_++, detour, before});
    }

    [[nodiscard]] bool prefersIn(Diagram::NodeId id) const {
        const Diagram::Node& node = diagram_.nodes[id];
        return node.cost + cheapest_[node.in] <= cheapest_[node.out];
    }
    [[nodiscard]] Diagram::NodeId cheaper(Diagram::NodeId id) const {
        return prefersIn(id) ? diagram_.nodes[id].in : diagram_.nodes[id].out;
    }
    [[nodiscard]] Diagram::NodeId moreExpensive(Diagram::NodeId id) const {
        return prefersIn(id) ? diagram_.nodes[id].out : diagram_.nodes[id].in;
    }

    /// The heap of all detours from a node on, built on first use.
    std::uint32_t heapAfter(Diagram::NodeId from) {
        std::vector<Diagram::NodeId> path;
        for (; heaps_[from] == unknown; from = cheaper(from))
            path.push_back(from);
        std::uint32_t heap = heaps_[from];
        for (; !path.empty(); path.pop_back()) {
            const Diagram::NodeId id = path.back();
            const Diagram::Node& node = diagram_.nodes[id];
            const double extra = std::abs(node.cost + cheapest_[node.in] - cheapest_[node.out]);
            if (extra < infinity) heap = merge(heap, add({extra, id, 0, 0, 1}));
            heaps_[id] = heap;
        }
        return heap;
    }

    std::uint32_t add(const Detour& detour) {
        detours_.push_back(detour);
        return static_cast<std::uint32_t>(detours_.size() - 1);
    }

    /// A new heap that holds the detours of two heaps.
    std::uint32_t merge(std::uint32_t a, std::uint32_t b) {
        if (a == 0 || b == 0) return a + b;
        if (detours_[b].extra < detours_[a].extra) std::swap(a, b);
        Detour top = detours_[a];
        top.right = merge(top.right, b);
        if (detours_[top.left].rank < detours_[top.right].rank) std::swap(top.left, top.right);
        top.rank = detours_[top.right].rank + 1;
        return add(top);
    }

    const Assignment& graphOf(std::int64_t path) {
        std::vector<Diagram::NodeId> detours;
        for (; path >= 0; path = paths_[at(path)].before)
            if (const std::uint32_t detour = paths_[at(path)].detour; detour != 0)
                detours.push_back(detours_[detour].node);
        graph_ = graphAlong(diagram_, [&](Diagram::NodeId id) {
            const bool leaves = !detours.empty() && detours.back() == id;
            if (leaves) detours.pop_back();
            return prefersIn(id) != leaves;
        });
        return graph_;
    }

    const Diagram& diagram_;
    std::vector<double> cheapest_;
    std::vector<std::uint32_t> heaps_; ///< heap of every node
    std::vector<Detour> detours_;      ///< entry 0 stands for no detour
    std::vector<Path> paths_;          ///< visited so far
    std::priority_queue<Path> open_;
    std::uint64_t offered_ = 0;
    Assignment graph_;
};

/// Sorts graphs of equal cost by their variables; without this, their order would depend on rounding and on
/// the shape of the diagram.
class Ties {
public:
    using Visit = std::function<bool(double cost, const Assignment& graph)>;
    explicit Ties(const Visit& visit) : visit_(visit) {}

    /// \return false if the visitor returned false
    bool add(double cost, const Assignment& graph) {
        const bool tied = !graphs_.empty() && cost <= minCost_ + Incumbents::rounding;
        if ((!tied || graphs_.size() * graph.size() >= maxBytes) && !handOver()) return false;
        if (graphs_.empty()) minCost_ = cost;
        graphs_.emplace_back(graph, cost);
        return true;
    }

    bool handOver() {
        std::ranges::sort(graphs_);
        for (const auto& [graph, cost] : std::exchange(graphs_, {}))
            if (!visit_(cost, graph)) return false;
        return true;
    }

private:
    static constexpr std::size_t maxBytes = 64'000'000;
    const Visit& visit_;
    double minCost_ = 0;
    std::vector<std::pair<Assignment, double>> graphs_;
};

} // namespace

bool forEachRankedGraph(const Diagram& diagram,
                        const std::function<bool(double cost, const Assignment& graph)>& visit,
                        const Control& control) {
    if (diagram.root == Diagram::none) return true;
    Ties ties(visit);
    bool isStopped = false;
    const auto add = [&](double cost, const Assignment& graph) {
        isStopped = control.stopRequested();
        return !isStopped && ties.add(cost, graph);
    };
    if (Ranking(diagram).run(add) || isStopped) ties.handOver();
    return !isStopped;
}

} // namespace qm
