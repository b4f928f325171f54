#include "check/document/report.h"

#include "base/number_text.h"

#include <nlohmann/json.hpp>

namespace qm::check {

std::string reportText(const Report& report) {
    std::string text;
    for (const std::string& what : report.verified())
        text += "ok: " + what + "\n";
    return text + (report.ok() ? "true\n" : "false: " + countText(report.total(), "violation") + "\n");
}

std::string reportJson(const Report& report) {
    nlohmann::ordered_json json{{"ok", report.ok()},
                                {"verified", report.verified()},
                                {"violationCount", report.total()},
                                {"violations", nlohmann::ordered_json::array()}};
    for (const Violation& each : report.violations())
        json["violations"].push_back(
            {{"pointer", each.pointer}, {"rule", each.rule}, {"explanation", each.explanation}});
    return json.dump(2) + "\n";
}

std::vector<std::string> violationLines(const Report& report, std::size_t max) {
    std::vector<std::string> lines;
    for (const Violation& each : report.violations()) {
        if (lines.size() == max) break;
        lines.push_back((each.pointer.empty() ? "" : each.pointer + ": ") + each.rule + ": " +
                        each.explanation);
    }
    if (report.total() > lines.size()) lines.push_back(countText(report.total(), "violation") + " in all");
    return lines;
}

} // namespace qm::check
