#include "cli/tools/export_date.h"

#include "base/error.h"
#include "base/number_text.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>

namespace qm {
namespace {

/// Year, month, day, hour, minute and second.
using DateParts = std::array<int, 6>;

DateParts lastChange(const std::string& path) {
    using namespace std::chrono;
    std::error_code missing;
    const auto changed = std::filesystem::last_write_time(path, missing);
    if (missing) throw Error(path, "is gone", "Give the date itself with --date");
    const auto time = floor<seconds>(file_clock::to_sys(changed));
    const year_month_day date(floor<days>(time));
    const hh_mm_ss clock(time - floor<days>(time));
    return {static_cast<int>(date.year()),
            static_cast<int>(static_cast<unsigned>(date.month())),
            static_cast<int>(static_cast<unsigned>(date.day())),
            static_cast<int>(clock.hours().count()),
            static_cast<int>(clock.minutes().count()),
            static_cast<int>(clock.seconds().count())};
}

/// \return nothing if the text has not the form of a date; its numbers may be too large for one
std::optional<DateParts> partsIn(std::string_view text) {
    constexpr std::string_view pattern = "0000-00-00T00:00:00";
    if (text.size() != pattern.size() && text.size() != pattern.find('T')) return std::nullopt;
    DateParts parts{};
    for (std::size_t k = 0, part = 0; k < text.size(); ++k) {
        const bool isDigit = text[k] >= '0' && text[k] <= '9';
        if (pattern[k] == '0' ? !isDigit : text[k] != pattern[k]) return std::nullopt;
        if (isDigit)
            parts.at(part) = 10 * parts.at(part) + (text[k] - '0');
        else
            ++part;
    }
    return parts;
}

bool isInCalendar(const DateParts& parts) {
    using namespace std::chrono;
    const year_month_day date{year{parts[0]}, month{static_cast<unsigned>(parts[1])},
                              day{static_cast<unsigned>(parts[2])}};
    return date.ok() && parts[3] <= 23 && parts[4] <= 59 && parts[5] <= 59;
}

std::string padded(int number, std::size_t digits) {
    const std::string shortest = numberText(number);
    return std::string(digits - std::min(digits, shortest.size()), '0') + shortest;
}

std::string textOf(const DateParts& parts) {
    std::string result = padded(parts[0], 4);
    for (std::size_t k = 1; k < parts.size(); ++k)
        result += "--T::"[k - 1] + padded(parts.at(k), 2);
    return result;
}

} // namespace

std::string exportDate(const std::string& text, const std::string& meshPath) {
    if (text == "mesh") return textOf(lastChange(meshPath));
    const std::optional<DateParts> parts = partsIn(text);
    if (!parts || !isInCalendar(*parts))
        throw Error("", "'" + text + "' is no date",
                    "Give one such as 2026-11-22 or 2026-11-22T10:00:00, or mesh");
    return textOf(*parts);
}

} // namespace qm
