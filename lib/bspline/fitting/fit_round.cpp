#include "bspline/fitting/fit_round.h"

#include <algorithm>
#include <numeric>

namespace qm {

double missedBy(const PatchErrors& errors) {
    constexpr double foldsAlone = 0.05;
    if (const double farthest = errors.maxDistance(); farthest > 1) return farthest - 1;
    return errors.max() > 1 ? foldsAlone : 0;
}

RoundScore scoreOf(const std::vector<double>& missed, bool keeps, const std::vector<Patch>& patches) {
    constexpr double share = 0.2; // many patches that miss a little are worse than one
    const double all = std::accumulate(missed.begin(), missed.end(), 0.0);
    const double largest = missed.empty() ? 0 : std::ranges::max(missed);
    return {keeps, largest + share * all, controlPointCount(patches)};
}

bool isBetter(const RoundScore& one, const RoundScore& other, Criterion first) {
    constexpr double factor = 1.05;
    constexpr double negligible = 0.02; // a reduction of errors by less is worth no control points
    const auto isWorse = [](double a, double b) { return a > factor * b + negligible; };
    if (first == Criterion::tolerance && one.keeps != other.keeps) return one.keeps;
    if (isWorse(one.missed, other.missed) || isWorse(other.missed, one.missed))
        return one.missed < other.missed;
    if (one.keeps != other.keeps) return one.keeps;
    return one.controlPoints < other.controlPoints;
}

} // namespace qm
