#include "cli/tools/surface_warnings.h"

#include "base/number_text.h"
#include "base/positions.h"
#include "bspline/splines/evaluate.h"
#include "cli/tool.h"
#include "summary/figure_text.h"
#include "summary/summary.h"

#include <algorithm>
#include <string>

namespace qm {

namespace {

double extentOf(const Surfaces& surfaces) {
    double extent = 0;
    for (const Patch& patch : surfaces.patches)
        extent = std::max(extent, (patch.controlPoints.back() - patch.controlPoints.front()).norm());
    return extent;
}

} // namespace

void warnOfGaps(const Tool& tool, const Surfaces& surfaces) {
    const double gap = surfaces.deviation.largestGap;
    if (gap > stepTolerance)
        tool.warn("patches are up to " + figureText(gap) + " apart, and STEP joins what is nearer than " +
                  figureText(stepTolerance) + ". The option --fit smooth leaves no gaps");
}

void warnOfFolds(const Tool& tool, const Surfaces& surfaces) {
    const std::size_t folds = surfaces.deviation.folds;
    if (folds == 0) return;
    const auto worst = std::ranges::max_element(surfaces.ofPatch, {}, &Deviation::folds);
    std::string where;
    if (worst != surfaces.ofPatch.end()) {
        const std::size_t patch = positionIn(surfaces.ofPatch, worst);
        where = ", " + std::to_string(worst->folds) + " of them in patch " + std::to_string(patch);
        const auto place = std::ranges::find(surfaces.folds, patch, &LayoutPlace::patch);
        if (place != surfaces.folds.end())
            where += " at " + pointText(pointAt(surfaces.patches, *place), extentOf(surfaces));
    }
    tool.warn(countText(folds, "piece") + " of patches may fold over" + where +
              ". Look at it with qm-view, and mend the mesh there or make it finer");
}

void warnOfCoverage(const Tool& tool, const Surfaces& surfaces) {
    constexpr double usual = 0.75;
    if (!surfaces.scan || surfaces.scan->coverage >= usual) return;
    const int percent = static_cast<int>(100 * surfaces.scan->coverage);
    tool.warn(
        "only " + std::to_string(percent) +
        " per cent of the mesh are near the scan; elsewhere the surfaces follow the quads. Is it a scan of "
        "the same part, in the same place and unit?");
}

void warnOfBridges(const Tool& tool, const Surfaces& surfaces, double allowed) {
    if (const auto bridged = bridgedVertex(surfaces, allowed))
        tool.warn("folded or nearly folded quads are bridged: a vertex is " + figureText(bridged->distance) +
                  " away from the surfaces, in patch " + std::to_string(bridged->patch) +
                  ". If they should pass through it, unfold the quads there");
}

} // namespace qm
