#include "enumerate/diagram/cheapest_graph.h"

#include "base/infinity.h"
#include "enumerate/state/incumbents.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace qm {
namespace {

/// All cheapest paths of a diagram, from which edges are cut until one path is left. Every edge is cut once
/// at most, and so are those that no path from the root to the end uses any more.
class CheapestPaths {
public:
    explicit CheapestPaths(const Diagram& diagram)
        : diagram_(diagram), nodesOf_(diagram.fixed.size()), kept_(2 * diagram.nodes.size(), 0),
          nextInto_(kept_.size(), noEdge), firstInto_(diagram.nodes.size(), noEdge),
          entering_(diagram.nodes.size(), 0), leaving_(diagram.nodes.size(), 0) {
        const std::vector<double> cheapest = cheapestPaths(diagram);
        entering_[diagram.root] = 1;
        for (Diagram::NodeId id = diagram.root; id > Diagram::end; --id) {
            if (entering_[id] == 0) continue;
            const Diagram::Node& node = diagram.nodes[id];
            const double limit = cheapest[id] + Incumbents::rounding;
            if (node.cost + cheapest[node.in] <= limit) keep(inEdge(id));
            if (cheapest[node.out] <= limit) keep(outEdge(id));
            if (node.variable.valid()) nodesOf_[node.variable].push_back(id);
        }
    }

    /// The graph in which variable after variable is out, wherever a path allows it.
    Assignment firstGraph() {
        for (const auto& nodes : nodesOf_)
            if (std::ranges::any_of(nodes, [&](Diagram::NodeId id) { return kept_[outEdge(id)]; }))
                for (const Diagram::NodeId id : nodes)
                    cut(inEdge(id));
        return graphAlong(diagram_, [&](Diagram::NodeId id) { return kept_[inEdge(id)]; });
    }

private:
    using Edge = std::size_t; ///< two leave every node
    static constexpr Edge noEdge = std::numeric_limits<Edge>::max();
    static Edge inEdge(Diagram::NodeId id) { return 2 * Edge{id}; }
    static Edge outEdge(Diagram::NodeId id) { return 2 * Edge{id} + 1; }
    static std::size_t source(Edge edge) { return edge / 2; }
    [[nodiscard]] Diagram::NodeId target(Edge edge) const {
        const Diagram::Node& node = diagram_.nodes[source(edge)];
        return edge % 2 == 0 ? node.in : node.out;
    }

    void keep(Edge edge) {
        const Diagram::NodeId to = target(edge);
        kept_[edge] = 1;
        nextInto_[edge] = std::exchange(firstInto_[to], edge);
        ++entering_[to];
        ++leaving_[source(edge)];
    }

    void cut(Edge first) {
        for (std::vector<Edge> pending{first}; !pending.empty();) {
            const Edge edge = pending.back();
            pending.pop_back();
            if (!std::exchange(kept_[edge], 0)) continue;
            if (--leaving_[source(edge)] == 0)
                for (Edge into = firstInto_[source(edge)]; into != noEdge; into = nextInto_[into])
                    pending.push_back(into);
            const Diagram::NodeId to = target(edge);
            if (--entering_[to] == 0) pending.insert(pending.end(), {inEdge(to), outEdge(to)});
        }
    }

    const Diagram& diagram_;
    IdVector<VariableId, std::vector<Diagram::NodeId>> nodesOf_;
    std::vector<char> kept_;              ///< by edge
    std::vector<Edge> nextInto_;          ///< the next edge with the same target
    std::vector<Edge> firstInto_;         ///< by node
    std::vector<std::uint32_t> entering_; ///< by node, the number of kept edges
    std::vector<std::uint32_t> leaving_;
};

} // namespace

std::vector<double> cheapestPaths(const Diagram& diagram) {
    std::vector<double> cheapest(diagram.nodes.size(), infinity);
    cheapest[Diagram::end] = 0;
    for (std::size_t id = Diagram::end + 1; id < cheapest.size(); ++id) {
        const Diagram::Node& node = diagram.nodes[id];
        cheapest[id] = std::min(node.cost + cheapest[node.in], cheapest[node.out]);
    }
    return cheapest;
}

std::optional<Assignment> cheapestGraph(const Diagram& diagram) {
    if (diagram.root == Diagram::none) return std::nullopt;
    return CheapestPaths(diagram).firstGraph();
}

} // namespace qm
