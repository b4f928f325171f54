#include "bspline/kink_reduction.h"

#include "base/parallel.h"
#include "bspline/agreed_normals.h"
#include "bspline/borders.h"
#include "bspline/patch_smoothing.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace qm {
namespace {

/// What the sum of squares has to grow by before a patch that could not turn is tried again.
constexpr double worthAnother = 1.2;

/// What is known of the patches from round to round.
class KinkReduction {
public:
    /// \param fit  is changed
    KinkReduction(const QuadMesh& mesh, const Layout& layout, ToleranceFit& fit, unsigned jobs);

    /// One round. \return which patches changed
    const std::vector<bool>& turn(const KinkLimits& limits);

    /// Makes patches that deviate what they were before the last round; the next ones come closer there.
    void takeBack(const DeviatingPlaces& places);

private:
    [[nodiscard]] bool hasNews(std::size_t patch) const;
    [[nodiscard]] SmoothedPatch turned(std::size_t patch, const KinkLimits& limits, bool mayGrow);

    ToleranceFit& fit_;
    unsigned jobs_;
    AgreedNormals agreed_;
    std::vector<std::vector<std::size_t>> neighbours_; ///< of every patch
    std::vector<bool> changed_;                        ///< by the last round
    std::vector<double> stuckAt_;                      ///< sums of squares that could not be made smaller
    bool mayGrow_ = false;                             ///< in the last round
    std::vector<Patch> before_;                        ///< the last round
};

KinkReduction::KinkReduction(const QuadMesh& mesh, const Layout& layout, ToleranceFit& fit, unsigned jobs)
    : fit_(fit), jobs_(jobs), agreed_(fit.curves()), neighbours_(layout.segments.size()),
      changed_(layout.segments.size(), true), stuckAt_(layout.segments.size(), 0) {
    for (const BorderEdge& border : borderEdges(mesh, layout)) {
        if (border.places.size() != 2) continue;
        for (const std::size_t p : {0U, 1U})
            neighbours_[border.places[p].patch].push_back(border.places[1 - p].patch);
    }
    for (auto& patches : neighbours_) {
        std::ranges::sort(patches);
        patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    }
}

/// Whether anything changed for the patch by the last round.
bool KinkReduction::hasNews(std::size_t patch) const {
    return changed_[patch] ||
           std::ranges::any_of(neighbours_[patch], [&](std::size_t k) { return changed_[k]; });
}

SmoothedPatch KinkReduction::turned(std::size_t patch, const KinkLimits& limits, bool mayGrow) {
    double largest = 0;
    double squares = 0;
    for (const double kink : agreed_.kinks(patch)) {
        largest = std::max(largest, kink);
        squares += kink * kink;
    }
    if (largest <= limits.angle) return {};
    if (mayGrow == mayGrow_ && !changed_[patch] && squares < worthAnother * stuckAt_[patch]) return {};
    PatchFitInput input = fit_.input(patch);
    input.normals = agreed_.of(patch);
    const double enough = limits.angle / 2; // the other half is the neighbour's
    SmoothedPatch result = smoothPatch(input, fit_.tolerance(), before_[patch], enough, mayGrow);
    stuckAt_[patch] = result.sameKnots || result.oneMoreKnot ? 0 : squares;
    return result;
}

const std::vector<bool>& KinkReduction::turn(const KinkLimits& limits) {
    before_ = fit_.patches();
    for (std::size_t k = 0; k < before_.size(); ++k)
        if (changed_[k]) agreed_.update(k, before_[k]);
    std::size_t points = controlPointCount(before_);
    const bool mayGrow = points < limits.mostPoints;
    std::vector<SmoothedPatch> found(before_.size());
    parallelFor(before_.size(), jobs_, [&](std::size_t k) {
        if (mayGrow != mayGrow_ || hasNews(k)) found[k] = turned(k, limits, mayGrow);
    });
    mayGrow_ = mayGrow;
    std::vector<std::size_t> order(before_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t k) { return found[k].gain; });
    changed_.assign(before_.size(), false);
    for (const std::size_t k : order) {
        auto& [sameKnots, oneMoreKnot, gain] = found[k];
        const std::size_t rest = points - before_[k].controlPoints.size();
        const bool grows = oneMoreKnot && rest + oneMoreKnot->controlPoints.size() <= limits.mostPoints;
        auto& next = grows ? oneMoreKnot : sameKnots;
        if (!next) continue;
        points = rest + next->controlPoints.size();
        fit_.replace(k, std::move(*next));
        changed_[k] = true;
    }
    return changed_;
}

void KinkReduction::takeBack(const DeviatingPlaces& places) {
    fit_.comeCloser(places);
    for (std::size_t k = 0; k < places.size(); ++k)
        if (!places[k].empty()) fit_.replace(k, before_[k]);
}

} // namespace

void reduceKinks(const QuadMesh& mesh, const Layout& layout, ToleranceFit& fit, const KinkLimits& kinks,
                 const DeviationMeter& meter, const DeviationLimits& limits, const Control& control) {
    constexpr int mostRounds = 20;
    constexpr int agreeing = 3; // rounds before there are more control points
    KinkReduction reduction(mesh, layout, fit, control.jobs);
    for (int round = 0; round < mostRounds; ++round) {
        control.progress(0.5 + 0.5 * round / mostRounds);
        const auto& changed = reduction.turn({kinks.angle, round < agreeing ? 0 : kinks.mostPoints});
        if (std::ranges::any_of(changed, std::identity()))
            reduction.takeBack(meter.find(fit.patches(), limits, changed, control));
        else if (round >= agreeing)
            return;
    }
}

} // namespace qm
