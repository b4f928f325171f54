/// \file A partial assignment that keeps itself consistent, with undo: the base of every search.
#pragma once

#include "enumerate/state/crack_rule.h"

#include <vector>

namespace qm {

/// Holds a value or "free" for every variable. `assign` draws the conclusions that rules 1 to 4 allow
/// locally; when no variable is free and no call has failed, the assignment is a motorcycle graph
/// (docs/METHOD.md#search-problem).
class SearchState {
public:
    explicit SearchState(const Problem& problem);
    SearchState(const SearchState&) = delete;
    SearchState& operator=(const SearchState&) = delete;

    /// False if the rules contradict each other already; then nothing else may be called.
    [[nodiscard]] bool consistent() const { return consistent_; }

    [[nodiscard]] const Problem& problem() const { return problem_; }
    [[nodiscard]] ArcState value(VariableId variable) const { return assignment_.value(variable); }
    [[nodiscard]] bool isFree(VariableId variable) const { return assignment_.isFree(variable); }
    [[nodiscard]] std::size_t freeVariables() const { return assignment_.freeVariables(); }
    /// A lower bound of the cost of every completion; when no variable is free, G_T up to rounding.
    [[nodiscard]] double bound() const { return assignment_.bound(); }
    /// The part of the bound that is due to the corners at a crossing.
    [[nodiscard]] double cornerBound(CrossingId crossing) const { return assignment_.cornerBound(crossing); }
    [[nodiscard]] ChainId chainOf(VariableId variable) const { return assignment_.chainOf(variable); }
    [[nodiscard]] const std::vector<CrossingId>& crossingsOf(VariableId variable) const {
        return assignment_.crossingsOf(variable);
    }
    [[nodiscard]] Cover coverOfChain(ChainId chain) const { return lines_.coverOf(chain); }
    /// True once a variable of the chain is out; always false for a chain not covered from both sides.
    [[nodiscard]] bool hasGap(ChainId chain) const { return lines_.hasGap(chain); }
    [[nodiscard]] const CrackRule& cracks() const { return cracks_; }

    /// A state to return to with `undo`.
    struct Mark {
        PartialAssignment::Mark assignment;
        LineRule::Mark lines;
        CrackRule::Mark cracks;
    };
    [[nodiscard]] Mark mark() const { return {assignment_.mark(), lines_.mark(), cracks_.mark()}; }
    void undo(const Mark& mark);

    /// Gives a variable a value and draws all local conclusions; nothing changes if it has that value
    /// already.
    /// \return false on a contradiction, also with the variable's value; the caller must then undo
    bool assign(VariableId variable, ArcState value) {
        return assignment_.set(variable, value) && propagate();
    }

    /// Covers a chain with two sources from end to end, or promises that it will have a gap.
    /// \return false on a contradiction; the caller must then undo
    bool decideCover(ChainId chain, bool full);

    /// The variables assigned since a mark, in order.
    [[nodiscard]] std::vector<VariableId> assignedSince(const Mark& mark) const;
    [[nodiscard]] Assignment assignment() const { return assignment_.assignment(); }

private:
    bool propagate();
    bool visitLine(VariableId variable);
    bool visitCrossing(CrossingId crossing);

    const Problem& problem_;
    PartialAssignment assignment_;
    LineRule lines_;
    CrackRule cracks_;
    std::size_t propagated_ = 0; ///< how many entries of the trail have been propagated
    bool consistent_ = true;
};

} // namespace qm
