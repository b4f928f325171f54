#include "cli/system/run_statistics.h"

#include "document/json/json.h"

#include <cstdint>
#include <optional>
#include <sys/resource.h>

namespace qm {
namespace {

double peakMegabytes() {
    struct rusage usage {};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024; // Linux counts in KiB
}

/// A whole number without an exponent, as far as doubles count.
Json counted(double value) {
    const std::optional<std::int64_t> whole = wholeNumber(value);
    return whole ? Json(*whole) : Json(value);
}

} // namespace

std::string RunStatistics::line(const std::string& tool) const {
    const std::chrono::duration<double> all = std::chrono::steady_clock::now() - start_;
    Json stats{{"tool", tool}};
    stats["seconds"] = (all - reading_).count();
    stats["inputSeconds"] = reading_.count();
    stats["peakMegabytes"] = peakMegabytes();
    stats["counters"] = Json::object();
    for (const auto& [counter, value] : counters_)
        stats["counters"][counter] = counted(value);
    std::string text = printJsonLine(stats);
    text.pop_back(); // the line end
    return text;
}

} // namespace qm
