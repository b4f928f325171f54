/// \file What the solvers of COIN-OR need: their number for infinity, and a way to stop them.
#pragma once

#include "base/control.h"

#include <coin/ClpEventHandler.hpp>
#include <coin/CoinFinite.hpp>

#include <cmath>

namespace qm {

/// A bound of a row or column, with the solvers' number for infinity.
inline double coinBound(double bound) {
    return std::isinf(bound) ? std::copysign(COIN_DBL_MAX, bound) : bound;
}

/// Ends the simplex method of Clp, which may take minutes, as soon as the caller asks for it. To be passed to
/// a solver, which copies it; the control must live as long as the solver solves. A solver that was stopped
/// has status 5.
class StopOnRequest : public ClpEventHandler {
public:
    explicit StopOnRequest(const Control& control) : control_(&control) {}
    int event(Event /*event*/) override { return control_->stopRequested() ? stop : goOn; }
    [[nodiscard]] ClpEventHandler* clone() const override { return new StopOnRequest(*this); }

private:
    static constexpr int stop = 5, goOn = -1; ///< return values defined by Clp
    const Control* control_;
};

} // namespace qm
