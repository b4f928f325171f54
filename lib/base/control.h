/// \file What a long computation may ask of its caller: to show progress, whether to stop, how many threads.
#pragma once

#include <functional>

namespace qm {

/// Passed by value; every member may be left as it is.
struct Control {
    /// Called now and then with the fraction done, 0 to 1; from one thread at a time.
    std::function<void(double fraction)> progress = [](double) {};
    /// Asked now and then; true means: return the best result so far.
    std::function<bool()> stopRequested = [] { return false; };
    /// Threads to use at most. Results do not depend on it, unless they are stopped.
    unsigned jobs = 1;
};

} // namespace qm
