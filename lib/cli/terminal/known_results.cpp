#include "cli/terminal/known_results.h"

#include "base/number_text.h"

#include <cmath>

namespace qm {

namespace {

constexpr std::chrono::seconds between{3};

std::string rounded(double value) {
    constexpr double digits = 1e4;
    return numberText(std::round(value * digits) / digits);
}

} // namespace

std::string knownText(double cost, double lowerBound) {
    const std::string text = "cost " + rounded(cost);
    if (!std::isfinite(lowerBound)) return text + ", no bound yet";
    return text + ", at least " + rounded(lowerBound) + ", gap " + rounded(cost - lowerBound);
}

bool LastReport::isDue() {
    Clock::rep last = last_;
    const Clock::rep now = Clock::now().time_since_epoch().count();
    if (Clock::duration(now - last) < between) return false;
    return last_.compare_exchange_strong(last, now);
}

} // namespace qm
