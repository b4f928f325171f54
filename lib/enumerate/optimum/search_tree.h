/// \file The tree of a branch and bound: the decisions that lead to each node, and the open nodes
/// (docs/METHOD.md#optimum).
#pragma once

#include "base/id_vector.h"
#include "enumerate/relaxation/column_state.h"

#include <algorithm>
#include <cstddef>
#include <queue>
#include <vector>

namespace qm {

class SearchTree {
public:
    using NodeId = Id<struct TreeNodeTag>;
    struct OpenNode {
        double bound;
        NodeId node;
        /// Orders the queue such that the lowest bound comes first, and among equal bounds the youngest node.
        bool operator<(const OpenNode& other) const {
            return bound != other.bound ? bound > other.bound : node < other.node;
        }
    };

    /// \param parent  none for the root, whose decision is ignored
    NodeId add(NodeId parent, const Decision& decision) {
        nodes_.push_back({parent, decision});
        return nodes_.nextId() - 1;
    }
    /// The number of all nodes, open or closed.
    [[nodiscard]] std::size_t size() const { return nodes_.size(); }
    [[nodiscard]] bool isRoot(NodeId node) const { return !nodes_[node].parent.valid(); }
    /// The decisions from the root down to a node.
    [[nodiscard]] std::vector<Decision> path(NodeId node) const {
        std::vector<Decision> decisions;
        for (; !isRoot(node); node = nodes_[node].parent)
            decisions.push_back(nodes_[node].decision);
        std::ranges::reverse(decisions);
        return decisions;
    }

    void open(NodeId node, double bound) { queue_.push({bound, node}); }
    [[nodiscard]] bool allClosed() const { return queue_.empty(); }
    /// The open node with the lowest bound; there must be an open node.
    [[nodiscard]] const OpenNode& next() const { return queue_.top(); }
    void closeNext() { queue_.pop(); }
    void closeAll() { queue_ = {}; }

private:
    struct Node {
        NodeId parent;
        Decision decision;
    };
    IdVector<NodeId, Node> nodes_;
    std::priority_queue<OpenNode> queue_;
};

} // namespace qm
