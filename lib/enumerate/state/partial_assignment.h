/// \file Values for some of the variables, with undo; the rules are not checked.
#pragma once

#include "enumerate/state/assignment.h"
#include "enumerate/state/values_with_undo.h"

#include <vector>

namespace qm {

/// Holds a value or "free" for every variable, and keeps the cost bound and the counts per chain up to date.
class PartialAssignment {
public:
    explicit PartialAssignment(const Problem& problem);

    [[nodiscard]] ArcState value(VariableId variable) const { return values_[variable]; }
    [[nodiscard]] bool isFree(VariableId variable) const { return value(variable) == ArcState::free; }
    [[nodiscard]] std::size_t freeVariables() const { return values_.size() - assigned().size(); }
    /// A lower bound of the cost of every completion; when no variable is free, G_T up to rounding.
    [[nodiscard]] double bound() const { return bound_; }
    /// The part of the bound that is due to the corners at a crossing.
    [[nodiscard]] double cornerBound(CrossingId crossing) const;
    /// The chain of a variable; none if it belongs to no chain.
    [[nodiscard]] ChainId chainOf(VariableId variable) const { return chainOf_[variable]; }
    [[nodiscard]] const std::vector<CrossingId>& crossingsOf(VariableId variable) const {
        return crossingsOf_[variable];
    }
    /// The number of variables of a chain that are in.
    [[nodiscard]] int inCount(ChainId chain) const { return inCount_[chain]; }

    /// Gives a variable a value.
    /// \return false if the variable has the other value already
    bool set(VariableId variable, ArcState value);

    struct Mark {
        std::size_t assignments = 0;
        double bound = 0;
    };
    [[nodiscard]] Mark mark() const { return {assigned().size(), bound_}; }
    void undo(const Mark& mark);

    /// The variables that have a value, in the order in which they were assigned.
    [[nodiscard]] const std::vector<VariableId>& assigned() const { return values_.given(); }
    /// All values; free variables count as out.
    [[nodiscard]] Assignment assignment() const;

private:
    [[nodiscard]] double cornerBounds(VariableId variable) const;

    const Problem& problem_;
    ValuesWithUndo<VariableId, ArcState> values_;
    IdVector<VariableId, ChainId> chainOf_;
    IdVector<VariableId, std::vector<CrossingId>> crossingsOf_;
    IdVector<ChainId, int> inCount_;
    double bound_ = 0;
    bool cornersCost_ = false;
};

} // namespace qm
