#include "check/document/check_history.h"

#include "check/document/json_values.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace qm::check {

namespace {

/// The tools of the pipeline in their order, and the kind that each leaves.
struct PipelineTool {
    const char* name;
    const char* kind;
};
constexpr std::array<PipelineTool, 7> pipeline{{{"qm-basecomplex", "basecomplex"},
                                                {"qm-features", "features"},
                                                {"qm-cut", "cut"},
                                                {"qm-enum", "enumeration"},
                                                {"qm-merge", "layout"},
                                                {"qm-prune", "layout"},
                                                {"qm-bspline", "surfaces"}}};

/// The ranks in the pipeline of the tools that took part, as the history has them, and where each stands
/// there.
std::vector<std::pair<std::size_t, std::size_t>> stages(const Json& root) {
    std::vector<std::pair<std::size_t, std::size_t>> result;
    const auto& history = elements(member(root, "history"));
    for (std::size_t i = 0; i < history.size(); ++i)
        for (std::size_t stage = 0; stage < pipeline.size(); ++stage)
            if (text(member(history[i], "tool")) == pipeline[stage].name) result.emplace_back(stage, i);
    return result;
}

} // namespace

bool wasPruned(const Json& root) {
    const auto all = stages(root);
    return std::any_of(all.begin(), all.end(), [](const auto& stage) {
        return std::string(pipeline[stage.first].name) == "qm-prune";
    });
}

void checkHistory(const Json& root, Report& report) {
    const auto all = stages(root);
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i].first < all[i - 1].first)
            report.violate(below("/history", all[i].second), "history",
                           std::string(pipeline[all[i].first].name) + " comes after " +
                               pipeline[all[i - 1].first].name + ", whose section it would have dropped");
    const auto kind = text(member(root, "kind"));
    if (all.empty() || kind != pipeline[all.back().first].kind)
        report.violate("/history", "history",
                       "its last tool makes no document of kind " + kind.value_or("unknown"));
}

} // namespace qm::check
