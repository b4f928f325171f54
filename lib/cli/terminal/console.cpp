#include "cli/terminal/console.h"

#include "base/number_text.h"
#include "cli/terminal/messages.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <unistd.h>

namespace qm {
namespace {

std::string rounded(double value) {
    constexpr double digits = 1e4;
    return numberText(std::round(value * digits) / digits);
}

/// "cost 12.5, at least 12.1, gap 0.4"
std::string knownText(double cost, double lowerBound) {
    const std::string text = "cost " + rounded(cost);
    if (!std::isfinite(lowerBound)) return text + ", no bound yet";
    return text + ", at least " + rounded(lowerBound) + ", gap " + rounded(cost - lowerBound);
}

} // namespace

void Console::say(const std::string& message) const {
    hideProgress();
    printMessage(tool_ + ": " + message);
}

void Console::warn(const std::string& message) const {
    if (!options_.quiet) say(message);
}

void Console::note(const std::string& message) const {
    if (options_.verbose && !options_.quiet) say(message);
}

KnownCost Console::sayingKnown() const {
    if (options_.quiet) return {};
    using Clock = std::chrono::steady_clock;
    const auto now = [] { return Clock::now().time_since_epoch().count(); };
    const auto last = std::make_shared<std::atomic<Clock::rep>>(now());
    return [this, now, last](double cost, double lowerBound) {
        constexpr std::chrono::seconds between{3};
        Clock::rep before = *last;
        if (Clock::duration(now() - before) >= between && last->compare_exchange_strong(before, now()))
            say(knownText(cost, lowerBound));
    };
}

std::function<void(double fraction)> Console::showProgress(const std::string& label) {
    if (options_.quiet || isatty(STDERR_FILENO) == 0) return {};
    progress_ = std::make_shared<Progress>(tool_ + ": " + label);
    return [bar = progress_](double fraction) { bar->show(fraction); };
}

void Console::hideProgress() const {
    if (progress_) progress_->hide();
}

} // namespace qm
