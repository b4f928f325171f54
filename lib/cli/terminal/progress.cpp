#include "cli/terminal/progress.h"

#include <algorithm>
#include <cmath>
#include <sys/ioctl.h>
#include <unistd.h>

namespace qm {

namespace {

constexpr double secondsBeforeFirst = 2;
constexpr double secondsBetween = 0.1;

std::size_t terminalColumns() {
    struct winsize size {};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

void toTerminal(const std::string& text) {
    // A bar that cannot be drawn is no reason to fail.
    [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, text.data(), text.size());
}

std::string durationText(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole < 60) return std::to_string(whole) + " s";
    if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

} // namespace

std::string progressText(const std::string& label, double fraction, double secondsSoFar,
                         std::size_t columns) {
    constexpr std::size_t width = 24;
    constexpr double longest = 1e6; // seconds; longer estimates are not worth showing
    fraction = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0;
    const auto filled = static_cast<std::size_t>(fraction * static_cast<double>(width));
    std::string text = label + " [" + std::string(filled, '=') + std::string(width - filled, ' ') + "] " +
                       std::to_string(static_cast<int>(fraction * 100)) + "%";
    const double left = fraction > 0 ? secondsSoFar * (1 - fraction) / fraction : longest;
    if (left < longest) text += ", about " + durationText(left) + " left";
    return text.substr(0, columns);
}

Progress::Progress(std::string label) : label_(std::move(label)) {}

Progress::~Progress() {
    hide();
}

void Progress::show(double fraction) {
    const std::scoped_lock lock(mutex_);
    const Clock::time_point now = Clock::now();
    const double total = std::chrono::duration<double>(now - start_).count();
    if (total < secondsBeforeFirst) return;
    if (visible_ && std::chrono::duration<double>(now - last_).count() < secondsBetween) return;
    last_ = now;
    visible_ = true;
    toTerminal("\r" + progressText(label_, fraction, total, terminalColumns() - 1) + "\033[K");
}

void Progress::hide() {
    const std::scoped_lock lock(mutex_);
    if (visible_) toTerminal("\r\033[K");
    visible_ = false;
}

} // namespace qm
