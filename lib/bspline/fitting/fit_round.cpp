#include "bspline/fitting/fit_round.h"

namespace qm {

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
