/// \file The best of the rounds of a search.
#pragma once

#include "bspline/fitting/fit_problem.h"
#include "bspline/fitting/fit_round.h"
#include "bspline/fitting/fit_state.h"

namespace qm {

class BestRounds {
public:
    /// \return whether the present round is the best so far by either criterion; then it is kept
    bool take(FitState& state);
    /// Keeps the present round, which keeps the tolerance, for want of one that does so with planes in place.
    void takeUnflattened(FitState& state) { unflattened_ = state.round(); }

    [[nodiscard]] bool keepsTolerance() const { return best_.score.keeps; }
    [[nodiscard]] std::size_t controlPoints() const { return best_.score.controlPoints; }

    /// The best round, with verified distances. The nearest one is better if the verification finds it
    /// nearer, which the lattices cannot tell. What is done to it counts from then on.
    [[nodiscard]] FitRound& choose(const Verification& verify);

private:
    FitRound best_;        ///< by whether the tolerance is kept
    FitRound nearest_;     ///< the best if errors that are given up count like all others
    FitRound unflattened_; ///< empty if none is needed
};

} // namespace qm
