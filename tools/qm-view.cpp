/// \file qm-view: shows documents as a page or as a picture.
#include "base/joined.h"
#include "cli/system/browser.h"
#include "cli/system/output_file.h"
#include "cli/tools/viewed_document.h"
#include "view/view_options.h"

int main(int argc, char** argv) {
    std::string png, size = "1200x900", show, from = "1,-1.5,0.9", up = "0,0,1", section, compare, reference;
    qm::LengthUnit unit = qm::LengthUnit::mm;
    bool key = true;
    return qm::runTool(argc, argv, "qm-view", "Show a document as a page or picture.", [&](qm::Tool& tool) {
        auto stage = std::make_shared<qm::Stage>(tool, qm::Kind::basecomplex, qm::Kind::basecomplex);
        tool.writes("one HTML page that needs no other file and no network");
        tool.explain("The results of each stage are layers; pointing at an element shows its number in the "
                     "document. Layers of faces, one at a time (zebra: reflected stripes; mean, gauss: "
                     "curvatures; tolerance: pass or fail; scan: distances from its triangles): " +
                     qm::joined(qm::faceLayerNames) +
                     ". Lines and points (jumps: angles between normals across smooth borders): " +
                     qm::joined(qm::lineLayerNames) + ".");
        tool.text("show", show, "LAYER,...", "layers shown initially, such as segments,borders",
                  qm::allLayerNames());
        tool.text("compare", compare, "DOCUMENT",
                  "show another document to the left of the first, with the same camera");
        tool.text("reference", reference, "FILE",
                  "the scan that the surfaces were fitted to, if it is not where the document says");
        tool.text("view", from, "X,Y,Z", "look from this direction");
        tool.text("up", up, "X,Y,Z", "the upward direction");
        tool.text("section", section, "AXIS:SHARE",
                  "cut the model open at this share of its extent, such as x:0.5");
        tool.option("unit", unit, "the mesh's unit");
        tool.text("png", png, "FILE",
                  "write a picture, rendered by Chromium; the page is written only if -o is given, too");
        tool.text("size", size, "WxH", "size of the picture, in pixels");
        tool.option("key", key, "leave the colour key out of the picture");
        tool.example("qm-view part.layout.json -o part.html");
        tool.example("qm-view --show cuts,submeshes,separatrices part.cut.json > part.html");
        tool.example("qm-view --compare part.layout.json part.surfaces.json --show zebra > both.html");
        tool.needs({"size", "no-key"}, "--png", [&] { return !png.empty(); });
        tool.verify([&] {
            (void)qm::parseSize(size), (void)qm::parseDirection(from), (void)qm::parseDirection(up);
            (void)qm::parseSection(section), (void)qm::parseLayers(show);
            if (tool.given("output") && qm::isSameFile(png, tool.outputPath()))
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
