#include "bspline/fitting/fitted.h"

#include <algorithm>

namespace qm {

double Fitted::farthest() const {
    return std::ranges::max(round.distances);
}

bool isAstrayFrom(const Fitted& before, const Fitted& found) {
    constexpr double farther = 1.2;
    constexpr double manyMore = 1.5;
    constexpr double littleNearer = 0.8;
    const auto points = [](const Fitted& fitted) {
        return static_cast<double>(controlPointCount(fitted.round.patches));
    };
    return found.farthest() > farther * before.farthest() ||
           (points(found) > manyMore * points(before) && found.farthest() > littleNearer * before.farthest());
}

bool isStuckAt(const Fitted& before, const Fitted& found) {
    constexpr double far = 1.2; // tolerances
    constexpr double hardlyNearer = 0.95;
    return found.farthest() > std::max(far, hardlyNearer * before.farthest());
}

} // namespace qm
