/// \file A progress bar on the terminal.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace qm {

/// A line on standard error with the fraction done and an estimate of the time left. It appears after two
/// seconds and disappears with the object.
class Progress {
public:
    explicit Progress(std::string label);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Both may be called from any thread.
    /// \param fraction  0 to 1
    void show(double fraction);
    /// Removes the line to make room for a message; the next `show` brings it back.
    void hide();

private:
    using Clock = std::chrono::steady_clock;

    std::mutex mutex_;
    std::string label_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    bool visible_ = false;
};

/// The text of the line, at most `columns` wide: label, bar, percentage, time left.
[[nodiscard]] std::string progressText(const std::string& label, double fraction, double secondsSoFar,
                                       std::size_t columns);

} // namespace qm
