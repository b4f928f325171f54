/// \file What a long search says while it runs.
#pragma once

#include <atomic>
#include <chrono>
#include <string>

namespace qm {

/// "cost 12.5, at least 12.1, gap 0.4"
[[nodiscard]] std::string knownText(double cost, double lowerBound);

/// Lets a report through every few seconds; for any number of threads.
class LastReport {
public:
    [[nodiscard]] bool isDue();

private:
    using Clock = std::chrono::steady_clock;
    std::atomic<Clock::rep> last_ = Clock::now().time_since_epoch().count();
};

} // namespace qm
