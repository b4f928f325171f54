/// \file Measuring the time of a computation in seconds.
#pragma once

#include "base/infinity.h"

#include <algorithm>
#include <chrono>

namespace qm::bench {

template <class Work> double secondsOf(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The shortest of several measurements; only one if it takes longer than `enough` seconds.
template <class Work> double shortestOf(int times, double enough, const Work& work) {
    double shortest = infinity;
    for (int k = 0; k < times && (k == 0 || shortest < enough); ++k)
        shortest = std::min(shortest, secondsOf(work));
    return shortest;
}

} // namespace qm::bench
