/// \file A partial assignment that keeps itself consistent, with undo: the base of every search.
#pragma once

#include "enumerate/state/assignment.h"
#include "enumerate/state/crack_forest.h"

#include <vector>

namespace qm {

/// Holds a value or "free" for every variable. `assign` draws the conclusions that rules 1 to 4 allow
/// locally; when no variable is free and no call has failed, the assignment is a motorcycle graph (method 2).
class SearchState {
public:
    explicit SearchState(const Problem& problem);

    /// False if the rules contradict each other already; then nothing else may be called.
    [[nodiscard]] bool consistent() const { return consistent_; }

    [[nodiscard]] ArcState value(int variable) const { return values_[static_cast<std::size_t>(variable)]; }
    [[nodiscard]] bool isFree(int variable) const { return value(variable) == ArcState::free; }
    [[nodiscard]] int freeVariables() const { return free_; }
    /// No completion costs less; G_T itself, but for rounding, when no variable is free.
    [[nodiscard]] double bound() const { return bound_; }
    /// The part of the bound that the corners at a crossing make up.
    [[nodiscard]] double cornerBound(int crossing) const;
    [[nodiscard]] const Problem& problem() const { return problem_; }
    [[nodiscard]] int chainOf(int variable) const { return chainOf_[static_cast<std::size_t>(variable)]; }
    /// The crack node of a chain; -1 if its line cannot be cracked.
    [[nodiscard]] int nodeOfChain(int chain) const { return nodeOfChain_[static_cast<std::size_t>(chain)]; }
    [[nodiscard]] const std::vector<int>& crossingsOfNode(int node) const {
        return crossingsOfNode_[static_cast<std::size_t>(node)];
    }
    /// A representative of the lines whose cracks depend on each other so far.
    [[nodiscard]] int crackGroup(int node) const { return cracks_.find(node); }
    /// Head-on meetings that a group of lines has left.
    [[nodiscard]] int cracksLeft(int group) const { return cracks_.left(group); }

    /// What is known of a line with two sources: covered from end to end, or with a gap.
    enum class Cover { open, full, gapped };
    [[nodiscard]] Cover coverOfChain(int chain) const;
    /// True once a variable of the chain is out.
    [[nodiscard]] bool hasGap(int chain) const {
        const Hull& hull = hulls_[static_cast<std::size_t>(chain)];
        return hull.first <= hull.last;
    }
    [[nodiscard]] const std::vector<int>& crossingsOf(int variable) const {
        return crossingsOf_[static_cast<std::size_t>(variable)];
    }

    /// All four arcs around a crossing are in.
    [[nodiscard]] bool isCrossed(int crossing) const;
    /// It is crossed, and not known yet which of its lines are covered from end to end.
    [[nodiscard]] bool isPending(int crossing) const {
        return !counted_[static_cast<std::size_t>(crossing)] && isCrossed(crossing);
    }
    /// No arc around a crossing is out.
    [[nodiscard]] bool mayBeCrossed(int crossing) const;

    /// A point to return to.
    struct Mark {
        std::size_t assignments = 0;
        std::size_t hulls = 0;
        std::size_t counted = 0;
        std::size_t cracks = 0;
        std::size_t promises = 0;
        double bound = 0;
    };
    [[nodiscard]] Mark mark() const;
    void undo(const Mark& mark);

    /// Sets a free variable and everything that follows. \return false on a contradiction; then undo
    bool assign(int variable, ArcState value);

    /// Covers a chain with two sources, or promises that it will have a gap. \return as of `assign`
    bool decideCover(int chain, bool full);

    /// The values set since a mark, in order.
    [[nodiscard]] std::vector<int> assignedSince(const Mark& mark) const;
    [[nodiscard]] Assignment assignment() const;

private:
    struct Hull { ///< of a chain's zeros; empty when first > last
        int first = 0;
        int last = -1;
    };
    struct HullChange {
        int chain;
        Hull before;
    };

    bool set(int variable, ArcState value);
    bool propagate();
    bool visitCrossing(int crossing);
    bool applyRule2(int crossing);
    bool visitChain(int variable);
    bool closeOneSided(const Chain& chain, int variable, ArcState value);
    bool openGap(int chain, int variable);
    bool countCrossing(int crossing);
    bool nodeDecided(int node);
    bool coverChain(int chain);

    [[nodiscard]] Cover coverOf(int node) const;
    [[nodiscard]] double cornerBounds(int variable) const;

    const Problem& problem_;
    std::vector<ArcState> values_;
    std::vector<int> chainOf_;                  ///< of every variable
    std::vector<std::vector<int>> crossingsOf_; ///< of every variable
    std::vector<int> nodeOfChain_;
    std::vector<std::vector<int>> crossingsOfNode_;
    std::vector<Hull> hulls_;    ///< of every chain
    std::vector<int> inCount_;   ///< variables of a chain that are in
    std::vector<bool> promised_; ///< chains that are to have a gap
    std::vector<bool> counted_;  ///< crossings that the crack forest knows
    CrackForest cracks_;
    std::vector<int> assigned_; ///< trail
    std::vector<HullChange> hullTrail_;
    std::vector<int> countedTrail_;
    std::vector<int> promiseTrail_;
    std::size_t propagated_ = 0; ///< how far the trail has been followed
    double bound_ = 0;
    int free_ = 0;
    bool cornersCost_ = false;
    bool consistent_ = true;
};

} // namespace qm
