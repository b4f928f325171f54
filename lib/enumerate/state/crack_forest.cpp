#include "enumerate/state/crack_forest.h"

#include <cstddef>
#include <utility>

namespace qm {

CrackForest::CrackForest(IdVector<CrackNodeId, int> capacities)
    : size_(capacities.size(), 1), left_(std::move(capacities)) {
    for (const CrackNodeId node : left_.ids())
        parent_.push_back(node);
}

CrackNodeId CrackForest::find(CrackNodeId node) const {
    while (parent_[node] != node)
        node = parent_[node];
    return node;
}

bool CrackForest::cross(CrackNodeId a, CrackNodeId b) {
    CrackNodeId root = find(a), child = find(b);
    if (root == child) {
        trail_.push_back({{}, root});
        return --left_[root] >= 0;
    }
    if (size_[root] < size_[child]) std::swap(root, child);
    parent_[child] = root;
    size_[root] += size_[child];
    left_[root] += left_[child] - 1;
    trail_.push_back({child, root});
    return left_[root] >= 0;
}

void CrackForest::undo(std::size_t changes) {
    while (trail_.size() > changes) {
        const Change change = trail_.back();
        trail_.pop_back();
        if (!change.child.valid()) {
            ++left_[change.root];
            continue;
        }
        parent_[change.child] = change.child;
        size_[change.root] -= size_[change.child];
        left_[change.root] -= left_[change.child] - 1;
    }
}

} // namespace qm
