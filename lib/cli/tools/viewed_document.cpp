#include "cli/tools/viewed_document.h"

#include "base/at.h"
#include "base/or_null.h"
#include "cli/tools/scan_input.h"
#include "document/files/files.h"
#include "document/summary_json.h"
#include "mesh/bounding_box.h"
#include "view/build_scene.h"

#include <algorithm>
#include <filesystem>

namespace qm {
namespace {

Viewed viewedOf(const Document& document, const Model& model, LengthUnit unit) {
    const FitOptions fit = recordedFit(JsonPlace(document.root)["history"]);
    const bool limited = model.surfaces && fit.fit == Fit::smooth;
    return {.title = std::filesystem::path(model.meshPath).filename().string(),
            .kind = document.root["kind"].get<std::string>(),
            .mesh = model.mesh,
            .dihedralAngles = model.dihedralAngles,
            .baseComplex = model.baseComplex,
            .features = model.features,
            .cut = orNull(model.cut),
            .enumeration = orNull(model.enumeration),
            .layout = orNull(model.layout),
            .surfaces = orNull(model.surfaces),
            .tolerance = limited ? std::optional(allowedDistance(*model.surfaces, fit,
                                                                 boundingBox(model.mesh).diagonal()))
                                 : std::nullopt,
            .rho = fit.rho,
            .maxNormalAngle = Limits{}.maxNormalAngle,
            .unit = std::string(choiceName(unit))};
}

} // namespace

ViewedDocuments::ViewedDocuments(const Tool& tool, Stage& stage, const ViewRequest& request)
    : tool_(tool), unit_(request.unit) {
    if (const std::string& other = request.compare; !other.empty()) {
        other_ = parseDocument(readFile(other), other);
        otherModel_ = readWholeModel(other_);
        tool.protect(other, "is the document that is compared");
        tool.protect(otherModel_.meshPath);
        for (const std::string& note : otherModel_.notes)
            tool.warn(displayName(other).append(": ").append(note));
        parts_.push_back({&other_, &otherModel_, readRecordedScan(tool, other_, "")});
    }
    const Model& model = stage.readWhole();
    tool.protectInput();
    parts_.push_back(
        {&stage.document(), &model, readRecordedScan(tool, stage.document(), request.reference)});
}

std::vector<Scene> ViewedDocuments::scenes(std::optional<std::size_t> maxPoints) const {
    std::vector<Scene> scenes;
    for (const Part& part : parts_) {
        Viewed viewed = viewedOf(*part.document, *part.model, unit_);
        viewed.scan = orNull(part.scan);
        viewed.maxPoints = maxPoints.value_or(viewed.maxPoints);
        scenes.push_back(buildScene(viewed, tool_.jobs()));
    }
    return scenes;
}

std::vector<Scene> ViewedDocuments::forPage() const {
    return scenes({});
}

std::vector<Scene> ViewedDocuments::forPicture(int width, int height) const {
    constexpr std::size_t fewest = 10'000;
    constexpr std::size_t pixels = 36; // per point: what lies between points is shaded smoothly
    const std::size_t all = at(width) * at(height);
    return scenes(std::clamp(all / pixels, fewest, Viewed::usualPoints));
}

} // namespace qm
