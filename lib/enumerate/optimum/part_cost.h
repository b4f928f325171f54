/// \file The cost that one part of a search problem adds to the cost of everything that is fixed.
#pragma once

#include "base/sort_unique.h"
#include "enumerate/state/search_state.h"

#include <vector>

namespace qm {

class PartCost {
public:
    /// \param variables  the free variables of an independent part
    PartCost(const SearchState& state, const std::vector<VariableId>& variables)
        : problem_(state.problem()), variables_(variables) {
        std::vector<CrossingId> crossings;
        for (const VariableId variable : variables)
            for (const CrossingId crossing : state.crossingsOf(variable))
                if (problem_.crossings[crossing].cornerCost != 0) crossings.push_back(crossing);
        sortUnique(crossings);
        crossings_ = std::move(crossings);
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

} // namespace qm
