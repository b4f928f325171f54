#include "enumerate/state/crack_forest.h"

#include <cstddef>
#include <numeric>
#include <utility>

namespace qm {

namespace {
std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}
} // namespace

CrackForest::CrackForest(std::vector<int> capacities)
    : parent_(capacities.size()), size_(capacities.size(), 1), left_(std::move(capacities)) {
    std::iota(parent_.begin(), parent_.end(), 0);
}

int CrackForest::find(int node) const {
    while (parent_[at(node)] != node)
        node = parent_[at(node)];
    return node;
}

bool CrackForest::cross(int a, int b) {
    int root = find(a), child = find(b);
    if (root == child) {
        trail_.push_back({-1, root});
        return --left_[at(root)] >= 0;
    }
    if (size_[at(root)] < size_[at(child)]) std::swap(root, child);
    parent_[at(child)] = root;
    size_[at(root)] += size_[at(child)];
    left_[at(root)] += left_[at(child)] - 1;
    trail_.push_back({child, root});
    return left_[at(root)] >= 0;
}

void CrackForest::undo(std::size_t changes) {
    while (trail_.size() > changes) {
        const Change change = trail_.back();
        trail_.pop_back();
        if (change.child < 0) {
            ++left_[at(change.root)];
            continue;
        }
        parent_[at(change.child)] = change.child;
        size_[at(change.root)] -= size_[at(change.child)];
        left_[at(change.root)] -= left_[at(change.child)] - 1;
    }
}

} // namespace qm
