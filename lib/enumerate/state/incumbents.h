/// \file The best graphs that a search has found so far.
#pragma once

#include "enumerate/state/assignment.h"

#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace qm {

/// Keeps the `capacity` cheapest distinct assignments; ties are in lexicographic order.
class Incumbents {
public:
    Incumbents(std::size_t capacity, double maxCost) : capacity_(capacity), maxCost_(maxCost) {}

    /// \return whether the assignment is new and cheap enough to be considered
    bool offer(double cost, const Assignment& assignment) {
        if (cost > maxCost_ + tolerance || !graphs_.emplace(cost, assignment).second) return false;
        if (graphs_.size() > capacity_) graphs_.erase(std::prev(graphs_.end()));
        return true;
    }

    /// The cost below which a graph is worth finding.
    [[nodiscard]] double cutoff() const {
        if (graphs_.size() < capacity_) return maxCost_ + tolerance;
        return graphs_.rbegin()->first - (capacity_ == 1 ? tolerance : -tolerance);
    }

    [[nodiscard]] bool empty() const { return graphs_.empty(); }
    [[nodiscard]] double bestCost() const { return graphs_.begin()->first; }

    /// Orders graphs by cost; if costs agree up to rounding, by the values of the variables.
    struct Order {
        using Graph = std::pair<double, Assignment>;
        bool operator()(const Graph& a, const Graph& b) const {
            const double costA = std::round(a.first / rounding), costB = std::round(b.first / rounding);
            return costA != costB ? costA < costB : a.second < b.second;
        }
    };
    [[nodiscard]] const std::set<std::pair<double, Assignment>, Order>& graphs() const { return graphs_; }

    /// Costs that differ by less than this count as equal in proofs.
    static constexpr double tolerance = 1e-7;
    /// An upper bound of the difference between sums of the same costs in different orders.
    static constexpr double rounding = 1e-9;

private:
    std::size_t capacity_;
    double maxCost_;
    std::set<std::pair<double, Assignment>, Order> graphs_;
};

} // namespace qm
