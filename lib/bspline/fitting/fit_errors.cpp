#include "bspline/fitting/fit_errors.h"

#include "base/parallel.h"

#include <algorithm>
#include <numeric>

namespace qm {
namespace {

/// By patch: whether its errors are of some kind.
template <class OfKind>
std::vector<bool> marked(const std::vector<PatchErrors>& errors, const OfKind& isOfKind) {
    std::vector<bool> marks(errors.size());
    std::transform(errors.begin(), errors.end(), marks.begin(), isOfKind);
    return marks;
}

/// By how much a patch exceeds the tolerance, in tolerances; a patch that is only folded counts a little.
double missedBy(const PatchErrors& errors) {
    constexpr double foldsAlone = 0.05;
    if (const double farthest = errors.maxDistance(); farthest > 1) return farthest - 1;
    return errors.max() > 1 ? foldsAlone : 0;
}

} // namespace

void FitErrors::measure(const std::vector<bool>& isNew, const std::vector<FitLattice>& lattices,
                        const std::vector<Patch>& patches, unsigned jobs) {
    parallelFor(ofPatch_.size(), jobs, [&](std::size_t k) {
        if (!isNew[k]) return;
        ofPatch_[k] = latticeErrors(lattices[k], patches[k], tolerance_, scale_[k]);
        missed_[k] = missedBy(ofPatch_[k]);
        givenUp_[k].cap(lattices[k], ofPatch_[k]);
    });
    worst_ = 0;
    excess_ = 0;
    for (const PatchErrors& errors : ofPatch_) {
        worst_ = std::max(worst_, errors.max());
        excess_ += std::max(0.0, errors.max() - 1);
    }
}

std::vector<bool> FitErrors::areMissed() const {
    return marked(ofPatch_, [](const PatchErrors& errors) { return errors.max() > 1; });
}

std::vector<bool> FitErrors::areFolded() const {
    return marked(ofPatch_, [](const PatchErrors& errors) { return errors.anyFolded(); });
}

bool FitErrors::isAnyFolded() const {
    return std::ranges::any_of(ofPatch_, [](const PatchErrors& errors) { return errors.anyFolded(); });
}

RoundScore FitErrors::scoreOf(const std::vector<Patch>& patches) const {
    constexpr double share = 0.2; // many patches that miss a little are worse than one
    const double all = std::accumulate(missed_.begin(), missed_.end(), 0.0);
    const double largest = missed_.empty() ? 0 : std::ranges::max(missed_);
    return {worst_ <= 1, largest + share * all, controlPointCount(patches)};
}

bool FitErrors::tighten(const std::vector<double>& distances) {
    // What is found may be so much farther than what the lattice shows.
    constexpr double agreement = 1.02;
    // Errors are scaled by so much in addition, lest the tolerance be just missed again.
    constexpr double reserve = 1.03;
    bool changed = false;
    for (std::size_t k = 0; k < distances.size(); ++k) {
        const double found = distances[k];
        const double told = ofPatch_[k].maxDistance();
        if (found <= 1 || found <= agreement * told || !(told > 0)) continue;
        scale_[k] *= reserve * found / told;
        changed = true;
    }
    return changed;
}

} // namespace qm
