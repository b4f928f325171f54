#include "cli/terminal/console.h"

#include "cli/terminal/known_results.h"
#include "cli/terminal/messages.h"

#include <unistd.h>

namespace qm {

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
    return [this, last = std::make_shared<LastReport>()](double cost, double lowerBound) {
        if (last->isDue()) say(knownText(cost, lowerBound));
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
