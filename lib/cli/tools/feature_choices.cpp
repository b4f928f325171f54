#include "cli/tools/feature_choices.h"

#include "base/number_text.h"
#include "cli/tool.h"

#include <numbers>
#include <string_view>

namespace qm {

namespace {

double parseAngle(std::string_view text) {
    const std::string whole(text);
    if (text.ends_with("deg")) text.remove_suffix(3);
    double degrees = 0;
    if (!parseNumber(text, degrees) || degrees < 0 || degrees > 180)
        throw UsageError("--min-angle: '" + whole + "' is no angle from 0 to 180 degrees, such as 25deg");
    return degrees * std::numbers::pi / 180;
}

} // namespace

void settleFeatureOptions(const Tool& tool, const std::string& minAngle, FeatureOptions& options) {
    if (tool.given("tau") && !tool.given("min-length")) options.minLength.value = 0;
    if (tool.given("tau") && !tool.given("max-roundness")) options.maxRoundness = 1;
    if (tool.given("tau") && !tool.given("short-rho")) options.shortRho = std::numbers::pi;
    if (tool.given("zeta") && !tool.given("min-distance")) options.minDistance.value = 0;
    if (minAngle.empty()) return;
    if (tool.given("rho")) throw UsageError("--rho and --min-angle are the same: give one of them");
    options.rho = parseAngle(minAngle);
}

} // namespace qm
