/// \file What a long computation needs from its caller: a place to report progress, requests to stop, a
/// number of threads.
#pragma once

#include <functional>

namespace qm {

/// Passed by value; every member has a usable default.
struct Control {
    /// Called now and then with the fraction done, 0 to 1; never by two threads at the same time.
    std::function<void(double fraction)> progress = [](double) {};
    /// Called now and then; if it returns true, the computation returns its best result so far.
    std::function<bool()> stopRequested = [] { return false; };
    /// The largest number of threads to use. Results do not depend on it, unless the computation is stopped.
    unsigned jobs = 1;
};

/// The same without reports of progress: for work that the reports do not count.
[[nodiscard]] inline Control unreported(Control control) {
    control.progress = Control().progress;
    return control;
}

/// Called now and then, from any thread, with the cost of the best result so far and with a lower bound of
/// all costs; the bound is minus infinity while none is known.
using KnownCost = std::function<void(double cost, double lowerBound)>;

} // namespace qm
