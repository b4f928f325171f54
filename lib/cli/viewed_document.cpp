#include "cli/viewed_document.h"

#include "bspline/splines/bounding_box.h"
#include "cli/scan_input.h"
#include "document/files.h"
#include "document/summary_json.h"
#include "view/build_scene.h"

#include <filesystem>

namespace qm {
namespace {

template <class Part> const Part* orNull(const std::optional<Part>& part) {
    return part ? &*part : nullptr;
}

Scene sceneOf(const Tool& tool, const Document& document, const Model& model, const std::string& reference,
              LengthUnit unit) {
    const FitOptions fit = recordedFit(JsonPlace(document.root)["history"]);
    const bool limited = model.surfaces && fit.fit == Fit::smooth;
    const auto scan = readRecordedScan(tool, document, reference);
    const Viewed viewed{
        .title = std::filesystem::path(model.meshPath).filename().string(),
        .kind = document.root["kind"].get<std::string>(),
        .mesh = model.mesh,
        .dihedralAngles = model.dihedralAngles,
        .baseComplex = model.baseComplex,
        .features = model.features,
        .cut = orNull(model.cut),
        .enumeration = orNull(model.enumeration),
        .layout = orNull(model.layout),
        .surfaces = orNull(model.surfaces),
        .scan = orNull(scan),
        .tolerance = limited ? allowedDistance(*model.surfaces, fit, boundingBoxDiagonal(model.mesh)) : 0,
        .rho = fit.rho,
        .unit = std::string(choiceName(unit))};
    return buildScene(viewed, tool.jobs());
}

} // namespace

std::vector<Scene> viewedScenes(const Tool& tool, Stage& stage, const std::string& other,
                                const std::string& reference, LengthUnit unit) {
    std::vector<Scene> scenes;
    if (!other.empty()) {
        Document document = parseDocument(readFile(other), other);
        const Model model = readWholeModel(document);
        tool.protect(other);
        tool.protect(model.meshPath);
        for (const std::string& note : model.notes)
            tool.warn(other + ": " + note);
        scenes.push_back(sceneOf(tool, document, model, "", unit));
    }
    const Model& model = stage.readWhole();
    scenes.push_back(sceneOf(tool, stage.document(), model, reference, unit));
    return scenes;
}

} // namespace qm
