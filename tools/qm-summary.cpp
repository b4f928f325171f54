/// \file qm-summary: prints the most important figures of a document for users of its surfaces.
#include "base/or_null.h"
#include "cli/stage.h"
#include "cli/tools/export_choices.h"
#include "document/summary_json.h"

#include <cmath>
#include <filesystem>

int main(int argc, char** argv) {
    qm::LengthUnit unit = qm::LengthUnit::mm;
    std::size_t maxPatches = 0;
    double seconds = qm::infinity; // not known
    bool asJson = false;
    qm::Limits limits;
    return qm::runTool(
        argc, argv, "qm-summary", "Report in a few lines how good a result is.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            auto stage = std::make_shared<qm::Stage>(tool, qm::Kind::basecomplex, qm::Kind::basecomplex);
            tool.writes("the summary");
            tool.explain(
                "If a limit is missed, a line says so, and the exit status is 3. The limits are the "
                "tolerance of the fit, twice the tolerance and seven times the noise for distances from a "
                "scan's own triangles, the options below, and that a closed mesh becomes a solid.");
            tool.option("max-patches", maxPatches, qm::Range{1, qm::maxCount},
                        "largest number of patches allowed");
            tool.option("max-normal-angle", limits.maxNormalAngle, qm::Range{0, 180},
                        "largest angle allowed between normals across smooth borders, in degrees");
            tool.option("unit", unit, "the mesh's unit");
            tool.option("seconds", seconds, qm::Range{0, qm::infinity},
                        "the time that the run took, to be included in the summary");
            tool.option("json", asJson, "write the summary as JSON");
            tool.example("qm-summary part.surfaces.json");
            tool.example("qm-summary --json --max-patches 200 part.pruned.json | jq .patches");
            return [&, stage] {
                const qm::Model& model = stage->readWhole();
                tool.protectInput();
                const qm::JsonPlace history = qm::JsonPlace(stage->document().root)["history"];
                if (tool.given("max-patches")) limits.maxPatches = maxPatches;
                const auto took = std::isfinite(seconds) ? std::optional(seconds) : std::nullopt;
                const std::string name = std::filesystem::path(model.meshPath).filename().string();
                const std::string unitName(qm::choiceName(unit));
                const qm::Summary summary =
                    qm::summarise(model.mesh, qm::orNull(model.layout), qm::orNull(model.surfaces),
                                  qm::recordedFit(history));
                const auto unmet = qm::unmetLimits(summary, limits, unitName);
                tool.write(asJson ? qm::printJson(qm::summaryToJson(summary, name, unitName, took, unmet))
                                  : qm::summaryText(summary, name, unitName, took));
                for (const std::string& sentence : unmet)
                    tool.warnOfInput(sentence);
                return unmet.empty() ? qm::exitDone : qm::exitUnmet;
            };
        });
}
