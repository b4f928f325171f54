/// \file Values of some of the variables, with undo, regardless of the rules.
#pragma once

#include "enumerate/state/assignment.h"

#include <vector>

namespace qm {

/// Holds a value or "free" for every variable, and keeps count of what follows from that alone.
class PartialAssignment {
public:
    explicit PartialAssignment(const Problem& problem);

    [[nodiscard]] ArcState value(int variable) const { return values_[static_cast<std::size_t>(variable)]; }
    [[nodiscard]] bool isFree(int variable) const { return value(variable) == ArcState::free; }
    [[nodiscard]] int freeVariables() const { return free_; }
    /// No completion costs less; G_T itself, but for rounding, when no variable is free.
    [[nodiscard]] double bound() const { return bound_; }
    /// The part of the bound that the corners at a crossing make up.
    [[nodiscard]] double cornerBound(int crossing) const;
    /// -1 if the variable is of no chain.
    [[nodiscard]] int chainOf(int variable) const { return chainOf_[static_cast<std::size_t>(variable)]; }
    [[nodiscard]] const std::vector<int>& crossingsOf(int variable) const {
        return crossingsOf_[static_cast<std::size_t>(variable)];
    }
    /// How many variables of a chain are in.
    [[nodiscard]] int inCount(int chain) const { return inCount_[static_cast<std::size_t>(chain)]; }

    /// \return false if the variable has the other value
    bool set(int variable, ArcState value);

    struct Mark {
        std::size_t assignments = 0;
        double bound = 0;
    };
    [[nodiscard]] Mark mark() const { return {assigned_.size(), bound_}; }
    void undo(const Mark& mark);

    /// The variables that have a value, in the order in which they got it.
    [[nodiscard]] const std::vector<int>& assigned() const { return assigned_; }
    /// Free variables count as out.
    [[nodiscard]] Assignment assignment() const;

private:
    [[nodiscard]] double cornerBounds(int variable) const;

    const Problem& problem_;
    std::vector<ArcState> values_;
    std::vector<int> chainOf_;                  ///< of every variable
    std::vector<std::vector<int>> crossingsOf_; ///< of every variable
    std::vector<int> inCount_;                  ///< of every chain
    std::vector<int> assigned_;                 ///< trail
    double bound_ = 0;
    int free_ = 0;
    bool cornersCost_ = false;
};

} // namespace qm
