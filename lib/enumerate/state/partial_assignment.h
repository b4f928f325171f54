/// \file Values of some of the variables, with undo, regardless of the rules.
#pragma once

#include "enumerate/state/assignment.h"

#include <vector>

namespace qm {

/// Holds a value or "free" for every variable, and keeps count of what follows from that alone.
class PartialAssignment {
public:
    explicit PartialAssignment(const Problem& problem);

    [[nodiscard]] ArcState value(VariableId variable) const { return values_[variable]; }
    [[nodiscard]] bool isFree(VariableId variable) const { return value(variable) == ArcState::free; }
    [[nodiscard]] int freeVariables() const { return free_; }
    /// No completion costs less; G_T itself, but for rounding, when no variable is free.
    [[nodiscard]] double bound() const { return bound_; }
    /// The part of the bound that the corners at a crossing make up.
    [[nodiscard]] double cornerBound(CrossingId crossing) const;
    /// None if the variable is of no chain.
    [[nodiscard]] ChainId chainOf(VariableId variable) const { return chainOf_[variable]; }
    [[nodiscard]] const std::vector<CrossingId>& crossingsOf(VariableId variable) const {
        return crossingsOf_[variable];
    }
    /// How many variables of a chain are in.
    [[nodiscard]] int inCount(ChainId chain) const { return inCount_[chain]; }

    /// \return false if the variable has the other value
    bool set(VariableId variable, ArcState value);

    struct Mark {
        std::size_t assignments = 0;
        double bound = 0;
    };
    [[nodiscard]] Mark mark() const { return {assigned_.size(), bound_}; }
    void undo(const Mark& mark);

    /// The variables that have a value, in the order in which they got it.
    [[nodiscard]] const std::vector<VariableId>& assigned() const { return assigned_; }
    /// Free variables count as out.
    [[nodiscard]] Assignment assignment() const;

private:
    [[nodiscard]] double cornerBounds(VariableId variable) const;

    const Problem& problem_;
    IdVector<VariableId, ArcState> values_;
    IdVector<VariableId, ChainId> chainOf_;
    IdVector<VariableId, std::vector<CrossingId>> crossingsOf_;
    IdVector<ChainId, int> inCount_;
    std::vector<VariableId> assigned_; ///< trail
    double bound_ = 0;
    int free_ = 0;
    bool cornersCost_ = false;
};

} // namespace qm
