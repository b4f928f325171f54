/// \file Adding a time limit to a caller's control.
#pragma once

#include "base/control.h"
#include "base/infinity.h"

#include <algorithm>
#include <chrono>
#include <optional>

namespace qm {

/// Must outlive the controls that it makes; these may be used on several threads.
class Deadline {
public:
    /// \param seconds  from now on; more than a year means no limit
    Deadline(const Control& control, double seconds) : control_(control) {
        using namespace std::chrono;
        if (seconds < duration<double>(hours(24 * 365)).count())
            end_ = steady_clock::now() + duration_cast<steady_clock::duration>(duration<double>(seconds));
    }

    /// Requests to stop when the caller does or when the time is up; reports no progress.
    [[nodiscard]] Control control() const {
        Control control;
        control.jobs = control_.jobs;
        control.stopRequested = [this] { return isOver() || control_.stopRequested(); };
        return control;
    }

    /// Never negative.
    [[nodiscard]] double secondsLeft() const {
        using namespace std::chrono;
        if (!end_) return infinity;
        return std::max(0.0, duration<double>(*end_ - steady_clock::now()).count());
    }

    [[nodiscard]] bool isOver() const { return end_ && std::chrono::steady_clock::now() >= *end_; }

private:
    const Control& control_;
    std::optional<std::chrono::steady_clock::time_point> end_;
};

} // namespace qm
