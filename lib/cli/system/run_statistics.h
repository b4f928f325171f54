/// \file The figures of --stats: time, memory, and counters of the tool.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace qm {

/// The figures of a run, which begins when this object is made.
class RunStatistics {
public:
    void count(const std::string& counter, double value) { counters_.emplace_back(counter, value); }
    /// Adds time spent on reading input, which in a pipe is mostly waiting for the previous tool.
    void addReading(std::chrono::duration<double> time) { reading_ += time; }
    /// All figures up to now as one line of JSON, without a line end.
    [[nodiscard]] std::string line(const std::string& tool) const;

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::chrono::duration<double> reading_{0};
    std::vector<std::pair<std::string, double>> counters_;
};

} // namespace qm
