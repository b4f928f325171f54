/// \file The data shared by all searches for graphs in one independent part of a problem.
#pragma once

#include "base/control.h"
#include "base/sort_unique.h"
#include "enumerate/optimum/part_options.h"
#include "enumerate/relaxation/column_state.h"
#include "enumerate/relaxation/relaxation.h"
#include "enumerate/state/incumbents.h"

#include <utility>
#include <vector>

namespace qm {

/// The cost that one part of a search problem adds to the cost of everything that is fixed.
class PartCost {
public:
    /// \param variables  the free variables of an independent part
    PartCost(const SearchState& state, const std::vector<VariableId>& variables)
        : problem_(state.problem()), variables_(variables) {
        for (const VariableId variable : variables)
            for (const CrossingId crossing : state.crossingsOf(variable))
                if (problem_.crossings[crossing].cornerCost != 0) crossings_.push_back(crossing);
        sortUnique(crossings_);
        fixed_ = corners([&](VariableId variable) { return state.value(variable) == ArcState::in; });
    }

    /// The cost of the part in a graph.
    /// \param isIn  whether a variable or constant is in
    template <class IsIn> [[nodiscard]] double of(const IsIn& isIn) const {
        double cost = corners(isIn) - fixed_;
        for (const VariableId variable : variables_)
            if (isIn(variable)) cost += problem_.costs[variable];
        return cost;
    }

    /// A lower bound of the part's cost in any completion of a state, which must be unchanged outside the
    /// part.
    [[nodiscard]] double lowerBound(const SearchState& state) const {
        double bound = -fixed_;
        for (const CrossingId crossing : crossings_)
            bound += state.cornerBound(crossing);
        for (const VariableId variable : variables_) {
            const double cost = problem_.costs[variable];
            if (state.value(variable) == ArcState::in || (state.isFree(variable) && cost < 0)) bound += cost;
        }
        return bound;
    }

private:
    template <class IsIn> [[nodiscard]] double corners(const IsIn& isIn) const {
        double cost = 0;
        for (const CrossingId crossing : crossings_)
            cost += problem_.crossings[crossing].cornerCost * problem_.crossings[crossing].corners(isIn);
        return cost;
    }

    const Problem& problem_;
    const std::vector<VariableId>& variables_;
    std::vector<CrossingId> crossings_; ///< crossings of the part whose corners have a cost
    double fixed_ = 0;                  ///< of the corners between arcs that were in from the start
};

/// A part of a problem, its relaxation, and the best graphs found so far.
struct PartSearch {
    /// \param variables  the free variables of the part
    PartSearch(SearchState& state, std::vector<VariableId> variables, const PartOptions& options,
               const Control& control);
    PartSearch(const PartSearch&) = delete;
    PartSearch& operator=(const PartSearch&) = delete;

    /// The value of a variable in the last relaxed solution.
    [[nodiscard]] double present(VariableId variable) const;
    /// The free columns whose value in the last relaxed solution is fractional, each with it.
    [[nodiscard]] std::vector<std::pair<ColumnId, double>> fractionalColumns() const;
    [[nodiscard]] bool allDecided() const;
    /// The simplex method's work so far, that of searches within this one included.
    [[nodiscard]] std::size_t work() const { return workElsewhere + relaxation.work(); }
    /// Whether to end with what is known: the limit of work is reached, or the caller asks for it.
    [[nodiscard]] bool isOver() const { return work() >= options.work || control.stopRequested(); }
    /// Offers the current state, in which every variable is decided, as a graph.
    void recordLeaf();

    SearchState& state;
    std::vector<VariableId> variables;
    PartCost cost;
    PartOptions options;
    const Control& control;
    Incumbents incumbents; ///< full assignments, of which only the part's variables count
    Formulation formulation;
    ColumnState columns;
    Relaxation relaxation;
    std::size_t workElsewhere = 0; ///< of relaxations before this one, and of searches within this one
};

} // namespace qm
