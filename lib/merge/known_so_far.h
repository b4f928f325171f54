/// \file The known cost and bound of a graph while it is being improved, for callers who want to follow.
#pragma once

#include "base/control.h"
#include "base/infinity.h"

#include <atomic>

namespace qm {

/// A cost and a lower bound that any thread may set.
class KnownSoFar {
public:
    /// \param tell  called from any thread; may be empty
    /// Both arguments must outlive the object.
    KnownSoFar(const Control& control, const KnownCost& tell, double cost)
        : control_(control), tell_(tell), cost_(cost) {}

    void setCost(double cost) { cost_ = cost; }
    void setBound(double bound) { bound_ = bound; }

    /// A control for searches that run at the same time: it shows no progress, but reports the known cost and
    /// bound whenever it is asked whether to stop.
    [[nodiscard]] Control control() const {
        Control control;
        control.jobs = control_.jobs;
        control.stopRequested = [this] {
            if (tell_) tell_(cost_, bound_);
            return control_.stopRequested();
        };
        return control;
    }

private:
    const Control& control_;
    const KnownCost& tell_;
    std::atomic<double> cost_;
    std::atomic<double> bound_ = -infinity;
};

} // namespace qm
