#include "check/document/check_history.h"

#include "check/document/json_values.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
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

/// A tool of the pipeline that took part.
struct Stage {
    const PipelineTool* tool; ///< of `pipeline`
    std::size_t entry;        ///< of the history
};

std::vector<Stage> stages(const Json& root) {
    std::vector<Stage> result;
    const JsonValue history = JsonValue(root)["history"];
    for (std::size_t i = 0; i < history.size(); ++i)
        for (const PipelineTool& tool : pipeline)
            if (history[i]["tool"].text() == tool.name) result.push_back({&tool, i});
    return result;
}

} // namespace

bool wasPruned(const Json& root) {
    return std::ranges::any_of(
        stages(root), [](const Stage& stage) { return std::string_view(stage.tool->name) == "qm-prune"; });
}

void checkHistory(const Json& root, Report& report) {
    const auto all = stages(root);
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i].tool < all[i - 1].tool)
            report.violate(below("/history", all[i].entry), "history",
                           std::string(all[i].tool->name) + " comes after " + all[i - 1].tool->name +
                               ", whose section it would have dropped");
    const auto kind = JsonValue(root)["kind"].text();
    if (all.empty() || kind != all.back().tool->kind)
        report.violate("/history", "history",
                       "its last tool makes no document of kind " + kind.value_or("unknown"));
}

} // namespace qm::check
