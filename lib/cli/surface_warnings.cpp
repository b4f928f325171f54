#include "cli/surface_warnings.h"

#include "cli/tool.h"
#include "summary/figure_text.h"
#include "summary/summary.h"

#include <algorithm>
#include <string>

namespace qm {

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
    if (worst != surfaces.ofPatch.end())
        where = ", " + std::to_string(worst->folds) + " of them in patch " +
                std::to_string(worst - surfaces.ofPatch.begin());
    tool.warn(countText(folds, "piece") + " of patches may fold over" + where +
              ". Look at it with qm-view, and mend the mesh there or make it finer");
}

} // namespace qm
