#include "bspline/fitting/fitted.h"

#include <algorithm>

namespace qm {
namespace {

struct Astray {
    static constexpr double distance = 1.2;
    static constexpr double points = 1.5;
    static constexpr double gain = 0.8; ///< share of the distance that is left
};

struct Stuck {
    static constexpr double distance = 1.2; ///< in tolerances
    static constexpr double gain = 0.95;    ///< share of the distance that is left
};

} // namespace

double Fitted::farthest() const {
    return std::ranges::max(round.distances);
}

bool isAstrayFrom(const Fitted& before, const Fitted& found) {
    const auto points = [](const Fitted& fitted) {
        return static_cast<double>(controlPointCount(fitted.round.patches));
    };
    return found.farthest() > Astray::distance * before.farthest() ||
           (points(found) > Astray::points * points(before) &&
            found.farthest() > Astray::gain * before.farthest());
}

bool isStuckAt(const Fitted& before, const Fitted& found) {
    return found.farthest() > std::max(Stuck::distance, Stuck::gain * before.farthest());
}

} // namespace qm
