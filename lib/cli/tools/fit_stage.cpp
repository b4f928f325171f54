#include "cli/tools/fit_stage.h"

#include "base/deadline.h"
#include "base/or_null.h"
#include "bspline/ranking.h"
#include "cli/tools/scan_input.h"
#include "cli/tools/surface_warnings.h"
#include "document/sections/surfaces_section.h"
#include "mesh/bounding_box.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

/// One of the layouts to choose from, with its fit.
struct Candidate {
    RankedLayout layout;
    std::string path;
    Document document; ///< only of the best layout
    Surfaces surfaces; ///< only of the best layout
};

/// Fits what the stage has read last.
Candidate fitted(Stage& stage, const FitOptions& options, const ScanInput& scan, const Control& control) {
    const Model& model = stage.model();
    Candidate candidate;
    candidate.surfaces =
        fitSurfaces(model.mesh, *model.layout, model.dihedralAngles, options, orNull(scan.surface), control);
    candidate.layout =
        rankedLayout(*model.layout, candidate.surfaces, missedTolerance(candidate.surfaces, options).empty());
    candidate.document = stage.release();
    candidate.path = candidate.document.path;
    return candidate;
}

/// Fits and ranks what the stage has read and all further layouts, or those until an interrupt or the limit
/// of time, best first; all but the best keep only their figures.
std::vector<Candidate> ranked(const Tool& tool, Stage& stage, const FitOptions& options,
                              const std::vector<std::string>& furtherFiles, const ScanInput& scan) {
    const Control all = tool.control("fitting");
    const Deadline end(all, options.timeLimit);
    const auto inTime = [&end](FitOptions fit) {
        fit.timeLimit = end.secondsLeft();
        return fit;
    };
    std::vector<Candidate> candidates;
    candidates.push_back(fitted(stage, inTime(options), scan, all));
    for (const std::string& file : furtherFiles) {
        const Control control = tool.control("fitting");
        if (control.stopRequested() || end.isOver()) break;
        stage.readAnother(file, candidates.front().document);
        candidates.push_back(fitted(stage, inTime(options), scan, control));
        if (ranksBefore(candidates.back().layout, candidates.front().layout))
            std::swap(candidates.front(), candidates.back());
        candidates.back().document = {};
        candidates.back().surfaces = {};
    }
    std::ranges::stable_sort(candidates, ranksBefore, &Candidate::layout);
    return candidates;
}

Json rankingToJson(const std::vector<Candidate>& candidates) {
    Json::array_t ranking;
    for (const Candidate& candidate : candidates)
        ranking.push_back({{"path", candidate.path},
                           {"segments", candidate.layout.segments},
                           {"cost", candidate.layout.cost},
                           {"controlPoints", candidate.layout.controlPoints},
                           {"maxRelative", candidate.layout.maxRelative},
                           {"keepsTolerance", candidate.layout.keeps}});
    return ranking;
}

} // namespace

void declareRequests(Tool& tool, FitRequests& requests, const FitOptions& options) {
    tool.text("reference", requests.reference, "FILE",
              "with --fit smooth: fit to this scan (triangles as STL, PLY, OBJ or OFF) instead of the smooth "
              "surface through the mesh's vertices");
    tool.option("rank", requests.rank,
                "fit every DOCUMENT, all layouts of the same mesh, and write the one that keeps the "
                "tolerance with the fewest control points");
    tool.readsMore(requests.furtherFiles);
    tool.needs({"reference", "rank"}, "--fit smooth", [&options] { return options.fit == Fit::smooth; });
    tool.verify([&requests] {
        if (!requests.rank && !requests.furtherFiles.empty())
            throw UsageError("unexpected operand " + requests.furtherFiles.front() +
                             ": several layouts are for --rank to choose from");
    });
}

int fitAndWrite(const Tool& tool, Stage& stage, const FitOptions& options, const FitRequests& requests) {
    (void)stage.read();
    const ScanInput scan = readScanInput(tool, requests.reference);
    std::vector<Candidate> candidates = ranked(tool, stage, options, requests.furtherFiles, scan);
    Candidate& best = candidates.front();
    const Surfaces& surfaces = best.surfaces;
    tool.count("patches", surfaces.patches.size());
    tool.count("controlPoints", best.layout.controlPoints);
    tool.count("maxDeviation", surfaces.deviation.max);
    Json section = surfacesToJson(surfaces, scan.file);
    if (requests.rank) section["ranking"] = rankingToJson(candidates);
    stage.resume(std::move(best.document));
    stage.write(options, std::move(section));
    if (surfaces.endedEarly) tool.warnOfInput("a limit ended the fit; with more time it may be closer");
    warnOfGaps(tool, surfaces);
    warnOfFolds(tool, surfaces);
    warnOfCoverage(tool, surfaces);
    if (options.fit == Fit::smooth)
        warnOfBridges(tool, surfaces,
                      allowedDistance(surfaces, options, boundingBox(stage.model().mesh).diagonal()));
    const std::string missed = missedTolerance(surfaces, options);
    if (missed.empty()) return exitDone;
    tool.warn(missed);
    return exitUnmet;
}

} // namespace qm
