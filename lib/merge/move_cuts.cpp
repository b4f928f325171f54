#include "merge/move_cuts.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

/// Variables of a window per unit of a sub-mesh's quasi-complexity, so that both are equally hard: about log2
/// of the candidate stops on a line of usual length.
constexpr double variablesPerBit = 6;
/// Limits: each window takes a fraction of a second, and all take a few seconds.
constexpr double maxVariables = 1000;
constexpr std::size_t maxWindows = 2000;
/// Nearly all models need a fiftieth of this work, which takes a few seconds. Where the relaxation is weak,
/// trees of 50 nodes alone would take as many minutes.
constexpr std::size_t maxWork = 200'000'000;

} // namespace

WindowResult moveCuts(const SearchSpace& space, const PresentArcs& present, double complexity,
                      IdVector<ArcId, double> relaxed, const Control& control) {
    WindowOptions options;
    options.relaxed = std::move(relaxed);
    options.minVariables = options.maxVariables =
        static_cast<std::size_t>(std::clamp(variablesPerBit * complexity, 1.0, maxVariables));
    options.maxWindows = maxWindows;
    options.work = maxWork / 10;
    options.maxWork = maxWork;
    return improveByWindows(wholeInput(space), present, options, control);
}

} // namespace qm
