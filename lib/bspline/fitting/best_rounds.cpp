#include "bspline/fitting/best_rounds.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

bool isBetterBy(Criterion criterion, const RoundScore& score, const FitRound& kept) {
    return kept.patches.empty() || isBetter(score, kept.score, criterion);
}

/// The largest distance of a round, in tolerances.
double verified(FitRound& round, const Verification& verify) {
    if (round.distances.empty()) round.distances = verify(round.patches);
    return std::ranges::max(round.distances);
}

} // namespace

bool BestRounds::take(FitState& state) {
    const RoundScore score = state.score();
    const bool isBest = isBetterBy(Criterion::tolerance, score, best_);
    const bool isNearest = isBetterBy(Criterion::errors, score, nearest_);
    if (!isBest && !isNearest) return false;
    const FitRound round = state.round();
    if (isBest) best_ = round;
    if (isNearest) nearest_ = round;
    return true;
}

FitRound& BestRounds::choose(const Verification& verify) {
    if (!best_.score.keeps && !unflattened_.patches.empty()) best_ = std::exchange(unflattened_, {});
    const double ofBest = verified(best_, verify);
    if (ofBest > 1 && !(nearest_.score == best_.score) && verified(nearest_, verify) < ofBest)
        best_ = std::move(nearest_);
    return best_;
}

} // namespace qm
