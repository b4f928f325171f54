/// \file qm-view: a document as a page to look at, or as a picture.
#include "cli/browser.h"
#include "cli/output_file.h"
#include "cli/stage.h"
#include "view/build_scene.h"
#include "view/view_options.h"

#include <filesystem>

namespace {

template <class Part> const Part* orNull(const std::optional<Part>& part) {
    return part ? &*part : nullptr;
}

qm::Scene sceneOf(const qm::Document& document, const qm::Model& model, unsigned jobs) {
    const std::string mesh = document.root["mesh"]["path"].get<std::string>();
    return qm::buildScene({std::filesystem::path(mesh).filename().string(),
                           document.root["kind"].get<std::string>(), model.mesh, model.dihedralAngles,
                           model.baseComplex, model.features, orNull(model.cut), orNull(model.enumeration),
                           orNull(model.layout), orNull(model.surfaces)},
                          jobs);
}

} // namespace

int main(int argc, char** argv) {
    std::string png, size = "1200x900", show, from = "1,-1.5,0.9", up = "0,0,1";
    return qm::runTool(argc, argv, "qm-view", "Show a document as a page to look at.", [&](qm::Tool& tool) {
        auto stage = std::make_shared<qm::Stage>(tool, qm::Kind::basecomplex, qm::Kind::basecomplex);
        tool.writes("one HTML page that needs no other file and no network");
        tool.explain(
            "What each stage found is a layer that is switched on and off; what is pointed at is named by "
            "its number in the document.");
        tool.text("show", show, "LAYER,...", "layers that are on at first, such as segments,borders");
        tool.text("view", from, "X,Y,Z", "look from this direction");
        tool.text("up", up, "X,Y,Z", "what is up");
        tool.text("png", png, "FILE", "write a picture, taken by Chromium; the page only if -o is given too");
        tool.text("size", size, "WxH", "of the picture, in pixels");
        tool.example("qm-view part.layout.json -o part.html");
        tool.example("qm-view --show cuts,submeshes,separatrices part.cut.json > part.html");
        tool.verify([&] {
            (void)qm::parseSize(size), (void)qm::parseDirection(from), (void)qm::parseDirection(up);
            if (png == tool.outputPath() && tool.given("output"))
                throw qm::UsageError("page and picture cannot go to the same place");
        });
        return [&, stage] {
            const qm::Model& model = stage->readWhole();
            const qm::Scene scene = sceneOf(stage->document(), model, tool.jobs());
            qm::PageOptions options{qm::parseNames(show), qm::parseDirection(from), qm::parseDirection(up)};
            if (png.empty() || tool.given("output")) tool.write(qm::printPage(scene, options));
            if (png.empty()) return qm::exitDone;
            options.still = true;
            const auto [width, height] = qm::parseSize(size);
            qm::writeFile(png, qm::photographPage(qm::printPage(scene, options), width, height));
            return qm::exitDone;
        };
    });
}
