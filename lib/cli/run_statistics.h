/// \file The figures of --stats: time, memory, and what a tool counts.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace qm {

/// Of a run that begins when this is made.
class RunStatistics {
public:
    void count(const std::string& counter, double value) { counters_.emplace_back(counter, value); }
    /// Time that was spent reading the input: in a pipe that is mostly waiting for the tool before.
    void addReading(std::chrono::duration<double> time) { reading_ += time; }
    /// All figures up to now as one line of JSON, without its end.
    [[nodiscard]] std::string line(const std::string& tool) const;

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::chrono::duration<double> reading_{0};
    std::vector<std::pair<std::string, double>> counters_;
};

} // namespace qm
