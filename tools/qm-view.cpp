/// \file qm-view: shows documents as a page or as a picture.
#include "cli/browser.h"
#include "cli/output_file.h"
#include "cli/viewed_document.h"
#include "view/view_options.h"

int main(int argc, char** argv) {
    std::string png, size = "1200x900", show, from = "1,-1.5,0.9", up = "0,0,1", section, compare, reference;
    qm::LengthUnit unit = qm::LengthUnit::mm;
    bool key = true;
    return qm::runTool(argc, argv, "qm-view", "Show a document as a page to look at.", [&](qm::Tool& tool) {
        auto stage = std::make_shared<qm::Stage>(tool, qm::Kind::basecomplex, qm::Kind::basecomplex);
        tool.writes("one HTML page that needs no other file and no network");
        tool.explain(
            "What each stage found is a layer that is switched on and off; what is pointed at is named by "
            "its number in the document. Layers of faces, one at a time: " +
            qm::joinedNames(qm::faceLayerNames) +
            ". Lines and points: " + qm::joinedNames(qm::lineLayerNames) +
            ". Zebra stripes are reflected ones, mean and gauss are curvatures, tolerance is pass or fail, "
            "scan is the distance from the scan's triangles, jumps are those of normals across smooth "
            "borders.");
        tool.text("show", show, "LAYER,...", "layers that are on at first, such as segments,borders",
                  qm::allLayerNames());
        tool.text("compare", compare, "DOCUMENT",
                  "another one, to the left of the first, seen by one camera");
        tool.text("reference", reference, "FILE",
                  "the scan that the surfaces were fitted to, if it is not where the document says");
        tool.text("view", from, "X,Y,Z", "look from this direction");
        tool.text("up", up, "X,Y,Z", "what is up");
        tool.text("section", section, "AXIS:SHARE", "cut the model open there, such as x:0.5");
        tool.option("unit", unit, "the mesh's unit");
        tool.text("png", png, "FILE", "write a picture, taken by Chromium; the page only if -o is given too");
        tool.text("size", size, "WxH", "of the picture, in pixels");
        tool.option("key", key, {}, "a picture of the model alone, without what its colours stand for");
        tool.example("qm-view part.layout.json -o part.html");
        tool.example("qm-view --show cuts,submeshes,separatrices part.cut.json > part.html");
        tool.example("qm-view --compare part.layout.json part.surfaces.json --show zebra > both.html");
        tool.needs({"size", "no-key"}, "--png", [&] { return !png.empty(); });
        tool.verify([&] {
            (void)qm::parseSize(size), (void)qm::parseDirection(from), (void)qm::parseDirection(up);
            (void)qm::parseSection(section), (void)qm::parseLayers(show);
            if (png == tool.outputPath() && tool.given("output"))
                throw qm::UsageError("page and picture cannot go to the same place");
        });
        return [&, stage] {
            const qm::ViewedDocuments documents(tool, *stage, compare, reference, unit);
            qm::PageOptions options{qm::parseLayers(show), qm::parseDirection(from), qm::parseDirection(up),
                                    qm::parseSection(section)};
            if (png.empty() || tool.given("output")) tool.write(qm::printPage(documents.forPage(), options));
            if (png.empty()) return qm::exitDone;
            options.still = true;
            options.key = key;
            const auto [width, height] = qm::parseSize(size);
            const std::string page = qm::printPage(documents.forPicture(width, height), options);
            qm::writeFile(png, qm::photographPage(page, width, height));
            return qm::exitDone;
        };
    });
}
