/// \file qm-bspline: a bicubic B-spline patch for every segment.
#include "bspline/fit.h"
#include "cli/scan_input.h"
#include "cli/stage.h"
#include "cli/surface_warnings.h"
#include "document/surfaces_section.h"

int main(int argc, char** argv) {
    qm::FitOptions options;
    std::string reference;
    return qm::runTool(
        argc, argv, "qm-bspline", "Fit a bicubic B-spline patch to every segment of a layout.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            auto stage =
                std::make_shared<qm::Stage>(tool, qm::Kind::layout, qm::Kind::layout, qm::Kind::surfaces);
            tool.options(options);
            tool.text(
                "reference", reference, "FILE",
                "with --fit smooth: a scan to fit to, triangles as STL, PLY, OBJ or OFF, instead of the "
                "smooth surface through the mesh's vertices");
            tool.example("qm-bspline part.layout.json -o part.surfaces.json");
            tool.example("qm-prune part.layout.json | qm-bspline --tolerance 0.5% > "
                         "part.surfaces.json");
            tool.example("qm-bspline --reference scan.stl part.layout.json > part.surfaces.json");
            tool.needs({"reference"}, "--fit smooth", [&] { return options.fit == qm::Fit::smooth; });
            return [&, stage] {
                const qm::Model& model = stage->read();
                const qm::ScanInput scan = qm::readScanInput(tool, reference);
                const qm::Surfaces surfaces =
                    qm::fitSurfaces(model.mesh, *model.layout, model.dihedralAngles, options,
                                    scan.surface ? &*scan.surface : nullptr, tool.control("fitting"));
                tool.count("patches", static_cast<double>(surfaces.patches.size()));
                tool.count("controlPoints", static_cast<double>(qm::controlPointCount(surfaces.patches)));
                tool.count("maxDeviation", surfaces.deviation.max);
                stage->write(options, qm::surfacesToJson(surfaces, scan.file));
                qm::warnOfGaps(tool, surfaces);
                qm::warnOfFolds(tool, surfaces);
                const std::string missed = qm::missedTolerance(surfaces, options);
                if (missed.empty()) return qm::exitDone;
                tool.warn(missed);
                return qm::exitUnmet;
            };
        });
}
