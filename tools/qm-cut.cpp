/// \file qm-cut: divides the mesh by minimum cuts into sub-meshes that can be searched one by one.
#include "cli/stage.h"
#include "cut/cut.h"
#include "document/sections/cut_section.h"

int main(int argc, char** argv) {
    qm::CutOptions options;
    return qm::runTool(
        argc, argv, "qm-cut", "Cut the mesh into sub-meshes of bounded complexity.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            auto stage =
                std::make_shared<qm::Stage>(tool, qm::Kind::features, qm::Kind::basecomplex, qm::Kind::cut);
            tool.options(options);
            tool.example("qm-cut --chi 20 part.features.json -o part.cut.json");
            tool.example("qm-basecomplex part.obj | qm-cut --terminals farthest > part.cut.json");
            return [&tool, &options, stage] {
                const qm::Model& model = stage->read();
                const qm::Cut cut = qm::cutMesh(model.mesh, model.complex, model.dihedralAngles, options,
                                                tool.control("cutting"));
                tool.count("subMeshes", cut.subMeshes.size());
                stage->write(options, qm::cutToJson(cut));
                return qm::exitDone;
            };
        });
}
