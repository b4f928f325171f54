#include "cli/tools/export_date.h"

#include "base/error.h"

#include <array>
#include <ctime>
#include <string_view>
#include <sys/stat.h>

namespace qm {
namespace {

std::string textOf(std::time_t moment) {
    std::tm parts{};
    gmtime_r(&moment, &parts);
    std::array<char, 64> text{};
    std::strftime(text.data(), text.size(), "%FT%T", &parts);
    return text.data();
}

} // namespace

std::string exportDate(const std::string& text, const std::string& meshPath) {
    if (text == "mesh") {
        struct stat status {};
        if (stat(meshPath.c_str(), &status) != 0)
            throw Error(meshPath, "is gone", "Give the date itself with --date");
        return textOf(status.st_mtime);
    }
    constexpr std::string_view dateAlone = "2026-11-22";
    const std::string whole = text + (text.size() == dateAlone.size() ? "T00:00:00" : "");
    std::tm parts{};
    strptime(whole.c_str(), "%FT%T", &parts);
    // What is in no calendar, such as the 30th of February, becomes another date; so does what is no date.
    if (textOf(timegm(&parts)) != whole)
        throw Error("", "'" + text + "' is no date",
                    "Give one such as 2026-11-22 or 2026-11-22T10:00:00, or mesh");
    return whole;
}

} // namespace qm
