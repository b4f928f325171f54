/// \file Messages about the intermediate results of a long search.
#pragma once

#include <atomic>
#include <chrono>
#include <string>

namespace qm {

/// "cost 12.5, at least 12.1, gap 0.4"
[[nodiscard]] std::string knownText(double cost, double lowerBound);

/// Limits reports to one every few seconds; may be used on several threads.
class LastReport {
public:
    [[nodiscard]] bool isDue();

private:
    using Clock = std::chrono::steady_clock;
    std::atomic<Clock::rep> last_ = Clock::now().time_since_epoch().count();
};

} // namespace qm
