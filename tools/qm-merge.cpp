/// \file qm-merge: merges the graphs of the sub-meshes into one layout of the whole mesh.
#include "cli/stage.h"
#include "document/sections/features_section.h"
#include "document/sections/layout_section.h"
#include "merge/merge.h"

int main(int argc, char** argv) {
    qm::MergeOptions options;
    return qm::runTool(
        argc, argv, "qm-merge", "Merge the graphs of the sub-meshes into one layout of segments.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            auto stage = std::make_shared<qm::Stage>(tool, qm::Kind::enumeration, qm::Kind::enumeration,
                                                     qm::Kind::layout);
            tool.options(options);
            tool.stopsGracefully();
            tool.example("qm-merge part.enumeration.json -o part.layout.json");
            tool.example("qm-basecomplex part.obj | qm-cut | qm-enum | qm-merge > part.layout.json");
            return [&tool, &options, stage] {
                const qm::Model& model = stage->read();
                const double chi = model.cut ? model.cut->options.chi : qm::CutOptions{}.chi;
                const qm::MergeResult merged =
                    qm::mergeGraphs(model.searched(), *model.enumeration, chi, options,
                                    tool.control("merging"), tool.sayingKnown());
                qm::Layout layout =
                    qm::buildLayout(model.mesh, merged.graph.tracks, model.dihedralAngles, model.edgeCosts);
                // Every layout also has the lines that components without sources get.
                if (merged.lowerBound)
                    layout.lowerBound = *merged.lowerBound + layout.cost - merged.graph.cost;
                tool.count("segments", layout.segments.size());
                tool.count("rounds", merged.rounds);
                qm::Json section = qm::layoutToJson(model.mesh, layout, model.dihedralAngles,
                                                    qm::sharpAngle(stage->document().root));
                section["merge"] = qm::mergeFigures(merged);
                stage->write(options, std::move(section));
                if (options.improve > 0 && model.enumeration->graphClass == qm::GraphClass::tmesh)
                    tool.warnOfInput("class tmesh is not improved");
                if (merged.endedEarly)
                    tool.warnOfInput("a limit ended the search; there may be cheaper layouts");
                return qm::exitDone;
            };
        });
}
