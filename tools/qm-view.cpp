/// \file qm-view: shows documents as a page or as a picture.
#include "base/joined.h"
#include "cli/tools/view_request.h"
#include "view/view_options.h"

int main(int argc, char** argv) {
    qm::ViewRequest request;
    return qm::runTool(argc, argv, "qm-view", "Show a document as a page or picture.", [&](qm::Tool& tool) {
        auto stage = std::make_shared<qm::Stage>(tool, qm::Kind::basecomplex, qm::Kind::basecomplex);
        tool.writes("one HTML page that needs no other file and no network");
        tool.explain("The results of each stage are layers; pointing at an element shows its number in the "
                     "document. Layers of faces, one at a time (zebra: reflected stripes; mean, gauss: "
                     "curvatures; tolerance: pass or fail; scan: distances from its triangles): " +
                     qm::joined(qm::faceLayerNames) +
                     ". Lines and points (jumps: angles between normals across smooth borders): " +
                     qm::joined(qm::lineLayerNames) + ".");
        tool.text("show", request.show, "LAYER,...", "layers shown initially, such as segments,borders",
                  qm::allLayerNames());
        tool.text("compare", request.compare, "DOCUMENT",
                  "show another document to the left of the first, with the same camera");
        tool.text("reference", request.reference, "FILE",
                  "the scan that the surfaces were fitted to, if it is not where the document says");
        tool.text("view", request.from, "X,Y,Z", "look from this direction");
        tool.text("up", request.up, "X,Y,Z", "the upward direction");
        tool.text("section", request.section, "AXIS:SHARE",
                  "cut the model open at this share of its extent, such as x:0.5");
        tool.option("unit", request.unit, "the mesh's unit");
        tool.text("png", request.png, "FILE",
                  "write a picture, rendered by Chromium; the page is written only if -o is given, too");
        tool.text("size", request.size, "WxH", "size of the picture, in pixels");
        tool.option("key", request.key, "leave the colour key out of the picture");
        tool.example("qm-view part.layout.json -o part.html");
        tool.example("qm-view --show cuts,submeshes,separatrices part.cut.json > part.html");
        tool.example("qm-view --compare part.layout.json part.surfaces.json --show zebra > both.html");
        tool.needs({"size", "no-key"}, "--png", [&] { return !request.png.empty(); });
        tool.verify([&] { qm::verify(tool, request); });
        return [&, stage] {
            qm::writeViews(tool, *stage, request);
            return qm::exitDone;
        };
    });
}
