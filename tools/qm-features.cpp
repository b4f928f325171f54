/// \file qm-features: curves along sharp edges become sources of particles.
#include "cli/stage.h"
#include "document/features_section.h"
#include "features/features.h"

int main(int argc, char** argv) {
    qm::FeatureOptions options;
    return qm::runTool(
        argc, argv, "qm-features", "Find feature curves, so that patch boundaries follow sharp edges.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            auto stage = std::make_shared<qm::Stage>(tool, qm::Kind::basecomplex, qm::Kind::basecomplex,
                                                     qm::Kind::features);
            tool.options(options);
            tool.example("qm-features part.basecomplex.json -o part.features.json");
            tool.example(
                "qm-basecomplex part.obj | qm-features --rho 0.5 --tau 5 --zeta 2 > part.features.json");
            return [&tool, &options, stage] {
                const qm::Model& model = stage->read();
                const qm::Features features = qm::findFeatures(model.mesh, model.dihedralAngles, options);
                tool.count("curves", static_cast<double>(features.curves.size()));
                stage->write(options, qm::featuresToJson(model.mesh, features, options));
                return qm::exitDone;
            };
        });
}
