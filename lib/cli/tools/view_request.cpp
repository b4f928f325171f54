#include "cli/tools/view_request.h"

#include "base/at.h"
#include "base/or_null.h"
#include "cli/system/browser.h"
#include "cli/system/output_file.h"
#include "cli/tools/scan_input.h"
#include "document/files/files.h"
#include "document/schema/misspelt_keys.h"
#include "document/summary_json.h"
#include "mesh/bounding_box.h"
#include "view/build_scene.h"
#include "view/view_options.h"

#include <algorithm>
#include <filesystem>

namespace qm {
namespace {

PageOptions pageOptions(const ViewRequest& request) {
    return {parseLayers(request.show), parseDirection(request.from), parseDirection(request.up),
            parseSection(request.section)};
}

/// A document that is shown.
struct Shown {
    const Document& document;
    const Model& model;
    std::optional<TriangleSurface> scan; ///< that its surfaces were fitted to, if it can be read
};

Scene sceneOf(const Shown& shown, LengthUnit unit, std::size_t maxPoints, unsigned jobs) {
    const Model& model = shown.model;
    const FitOptions fit = recordedFit(JsonPlace(shown.document.root)["history"]);
    const bool limited = model.surfaces && fit.fit == Fit::smooth;
    return buildScene({.title = std::filesystem::path(model.meshPath).filename().string(),
                       .kind = shown.document.root["kind"].get<std::string>(),
                       .mesh = model.mesh,
                       .dihedralAngles = model.dihedralAngles,
                       .baseComplex = model.baseComplex,
                       .features = model.features,
                       .cut = orNull(model.cut),
                       .enumeration = orNull(model.enumeration),
                       .layout = orNull(model.layout),
                       .surfaces = orNull(model.surfaces),
                       .scan = orNull(shown.scan),
                       .tolerance = limited ? std::optional(allowedDistance(
                                                  *model.surfaces, fit, boundingBox(model.mesh).diagonal()))
                                            : std::nullopt,
                       .rho = fit.rho,
                       .maxNormalAngle = Limits{}.maxNormalAngle,
                       .unit = std::string(choiceName(unit)),
                       .maxPoints = maxPoints},
                      jobs);
}

/// As many as a picture can show: what lies between points is shaded smoothly.
std::size_t pointsIn(const PictureSize& size) {
    constexpr std::size_t fewest = 10'000;
    constexpr std::size_t pixels = 36; // per point
    return std::clamp(at(size.width) * at(size.height) / pixels, fewest, Viewed::usualPoints);
}

/// A document to the left of the tool's own.
struct OtherDocument {
    OtherDocument(const Tool& tool, const std::string& path)
        : document(parseDocument(readFile(path), path)), model(readWholeModel(document)) {
        tool.protect(path, "is the document that is compared");
        tool.protect(model.meshPath);
        std::vector<std::string> sentences = misspeltKeys(document.root, document.root["kind"]);
        sentences.insert(sentences.end(), model.notes.begin(), model.notes.end());
        for (const std::string& sentence : sentences)
            tool.warn(displayName(path).append(": ").append(sentence));
    }
    Document document;
    Model model;
};

} // namespace

void verify(const Tool& tool, const ViewRequest& request) {
    (void)parseSize(request.size);
    (void)pageOptions(request);
    if (tool.given("output") && isSameFile(request.png, tool.outputPath()))
        throw UsageError("page and picture cannot go to the same place");
}

void writeViews(const Tool& tool, Stage& stage, const ViewRequest& request) {
    std::optional<OtherDocument> other;
    std::vector<Shown> shown; // from left to right
    if (!request.compare.empty()) {
        other.emplace(tool, request.compare);
        shown.push_back({other->document, other->model, readRecordedScan(tool, other->document, "")});
    }
    const Model& model = stage.readWhole();
    tool.protectInput();
    shown.push_back({stage.document(), model, readRecordedScan(tool, stage.document(), request.reference)});
    const auto page = [&](std::size_t maxPoints, const PageOptions& options) {
        std::vector<Scene> scenes;
        for (const Shown& each : shown)
            scenes.push_back(sceneOf(each, request.unit, maxPoints, tool.jobs()));
        return printPage(scenes, options);
    };

    PageOptions options = pageOptions(request);
    const bool isPictured = !request.png.empty();
    if (isPictured) verifyWritable(request.png); // before the page appears
    if (!isPictured || tool.given("output")) tool.write(page(Viewed::usualPoints, options));
    if (!isPictured) return;
    options.still = true;
    options.key = request.key;
    const PictureSize size = parseSize(request.size);
    writeFile(request.png, photographPage(page(pointsIn(size), options), size.width, size.height));
}

} // namespace qm
