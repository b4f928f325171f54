/// \file qm-features: makes curves along sharp edges sources of particles.
#include "cli/stage.h"
#include "cli/tools/feature_choices.h"
#include "document/sections/features_section.h"
#include "features/features.h"

int main(int argc, char** argv) {
    qm::FeatureOptions options;
    std::string minAngle;
    return qm::runTool(
        argc, argv, "qm-features", "Find feature curves, so that patch boundaries follow sharp edges.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            auto stage = std::make_shared<qm::Stage>(tool, qm::Kind::basecomplex, qm::Kind::basecomplex,
                                                     qm::Kind::features);
            tool.options(options);
            tool.text("min-angle", minAngle, "X[deg]", "--rho in degrees, such as 25deg");
            tool.verify([&] { qm::settleFeatureOptions(tool, minAngle, options); });
            tool.example("qm-features part.basecomplex.json -o part.features.json");
            tool.example("qm-basecomplex part.obj | qm-features --min-length 5% --min-angle 40deg > "
                         "part.features.json");
            tool.example("qm-basecomplex part.obj | qm-features --tau 15 --zeta 30 > part.features.json");
            return [&, stage] {
                const qm::Model& model = stage->read();
                const qm::Features features = qm::findFeatures(model.mesh, model.dihedralAngles, options);
                tool.count("curves", features.curves.size());
                stage->write(options, qm::featuresToJson(model.mesh, features, options));
                return qm::exitDone;
            };
        });
}
