/// \file qm-prune: removes boundaries that follow no feature.
#include "cli/stage.h"
#include "cli/tools/prune_messages.h"
#include "document/sections/features_section.h"
#include "document/sections/layout_section.h"
#include "prune/prune_optimum.h"

#include <cmath>

int main(int argc, char** argv) {
    qm::PruneOptions options;
    return qm::runTool(
        argc, argv, "qm-prune",
        "Remove flat boundaries from a layout, as long as every segment stays a grid.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            auto stage =
                std::make_shared<qm::Stage>(tool, qm::Kind::layout, qm::Kind::layout, qm::Kind::layout);
            tool.options(options);
            tool.stopsGracefully();
            tool.verify([&options] {
                if (options.fewestPatches && std::isfinite(options.maxSegments))
                    throw qm::UsageError("--fewest-patches and --max-segments exclude each other");
            });
            tool.example("qm-prune --eta -3 part.layout.json -o part.pruned.json");
            tool.example("qm-prune --method optimum --beta 2 --front part.layout.json -o part.pruned.json");
            tool.example("qm-prune --method optimum --fewest-patches part.layout.json -o part.pruned.json");
            tool.example("qm-merge part.enumeration.json | qm-prune --no-smooth > part.pruned.json");
            return [&tool, &options, stage] {
                const qm::Model& model = stage->read();
                options.constraints = model.constraints;
                const double rho = qm::sharpAngle(stage->document().root);
                const qm::PruneResult pruned =
                    qm::prune({model.mesh, model.complex, model.dihedralAngles, model.edgeCosts},
                              *model.layout, options, rho, tool.control("pruning"));
                qm::reportProofs(tool, options, pruned);
                tool.count("segments", pruned.layout.segments.size());
                tool.count("removedTracks", pruned.removedTracks);
                const qm::Json& before = stage->document().section(qm::Kind::layout).value();
                qm::Json section = qm::layoutToJson(model.mesh, pruned.layout, model.dihedralAngles, rho);
                if (before.contains("merge")) section["merge"] = before["merge"];
                section["prune"] = qm::pruneFigures(pruned);
                stage->write(options, std::move(section));
                return qm::exitDone;
            };
        });
}
