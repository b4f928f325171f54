/// \file Branch and bound on one part of a search problem.
#pragma once

#include "base/control.h"
#include "enumerate/incumbents.h"
#include "enumerate/relaxation.h"
#include "enumerate/search_state.h"

#include <queue>
#include <vector>

namespace qm {

/// Searches the free variables of one independent part; the rest of the state is left as it is.
class BranchAndBound {
public:
    /// \param state      consistent; the same after `run` as before
    /// \param variables  the free variables of the part
    BranchAndBound(SearchState& state, std::vector<int> variables, std::size_t best, double maxCost,
                   double gap, const Control& control);

    /// Begins with a known graph; only the part's variables of it count.
    void offer(const Assignment& assignment);
    void run();

    /// Graphs as full assignments, of which only the part's variables mean anything.
    [[nodiscard]] const Incumbents& incumbents() const { return incumbents_; }
    [[nodiscard]] double lowerBound() const { return lowerBound_; }
    [[nodiscard]] bool complete() const { return complete_; }
    [[nodiscard]] std::size_t nodes() const { return nodes_; }

private:
    /// A decision and what led to it; the root has no variable.
    struct Node {
        int parent = -1;
        Decision decision;
        double bound = 0;
    };
    struct OpenNode {
        double bound;
        int node;
        /// The queue hands out the least bound first, and of those the youngest.
        bool operator<(const OpenNode& other) const {
            return bound != other.bound ? bound > other.bound : node < other.node;
        }
    };
    /// Mean growth of the bound per unit of infeasibility, when a variable is set in or out.
    struct PseudoCost {
        double sum = 0;
        int count = 0;
    };
    struct Choice {
        Decision decision;  ///< its state is free; no variable if nothing is left to decide
        double boundIn = 0; ///< infinity if that side is empty
        double boundOut = 0;
    };

    bool replay(int node);
    void plunge(int node);
    bool fixByReducedCosts(double bound);
    bool acceptIntegral();
    void dive();
    void recordLeaf();
    [[nodiscard]] double partCost() const;
    Choice choose(double bound);
    Choice probe(int variable, double bound);
    std::optional<double> probeSide(int variable, ArcState value);
    [[nodiscard]] double score(int variable) const;
    void learn(int variable, ArcState value, double growth);
    int open(int parent, Decision decision, double bound);
    bool take(const Decision& decision);

    SearchState& state_;
    std::vector<int> variables_;
    Relaxation relaxation_;
    Incumbents incumbents_;
    std::size_t best_;
    double gap_;
    const Control& control_;
    std::vector<Node> tree_;
    std::vector<Decision> path_; ///< from the root to where the state is
    std::priority_queue<OpenNode> queue_;
    std::vector<PseudoCost> growthIn_; ///< of every variable of the problem
    std::vector<PseudoCost> growthOut_;
    SearchState::Mark root_;
    double lowerBound_ = 0;
    bool complete_ = true;
    std::size_t nodes_ = 0;
};

} // namespace qm
