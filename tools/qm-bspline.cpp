/// \file qm-bspline: fits a bicubic B-spline patch to every segment.
#include "bspline/fit.h"
#include "cli/tools/fit_stage.h"

int main(int argc, char** argv) {
    qm::FitOptions options;
    qm::FitRequests requests;
    return qm::runTool(
        argc, argv, "qm-bspline", "Fit a bicubic B-spline patch to every segment of a layout.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            auto stage =
                std::make_shared<qm::Stage>(tool, qm::Kind::layout, qm::Kind::layout, qm::Kind::surfaces);
            tool.explain("An interrupt ends the fit with the best surfaces so far.");
            tool.options(options);
            qm::declareRequests(tool, requests, options);
            tool.stopsGracefully();
            tool.example("qm-bspline part.layout.json -o part.surfaces.json");
            tool.example("qm-prune part.layout.json | qm-bspline --tolerance 0.5% > "
                         "part.surfaces.json");
            tool.example("qm-bspline --reference scan.stl part.layout.json > part.surfaces.json");
            tool.example("qm-prune part.layout.json -o part.pruned.json; "
                         "qm-bspline --rank part.layout.json part.pruned.json -o part.surfaces.json");
            return [&, stage] { return qm::fitAndWrite(tool, *stage, options, requests); };
        });
}
