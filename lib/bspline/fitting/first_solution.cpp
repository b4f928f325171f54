#include "bspline/fitting/first_solution.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace qm {
namespace {

/// Where patches fold, the distances of the first knots are reduced to this share, up to so many times; after
/// that, knots are inserted where they fold.
constexpr double closer = 0.3;
constexpr int maxTimesCloser = 3;

/// Folds of a reference that is nothing but noise take ever more knots: control points grow up to so many
/// times those of the first solution, and so many per quad in addition.
constexpr std::size_t maxGrowth = 8;
constexpr std::size_t maxPerQuad = 4;

class FirstSolution {
public:
    FirstSolution(FitState& state, int slides)
        : state_(state), setup_(state.setup()), slides_(slides), share_(setup_.sources.size(), 1) {}

    void solve() {
        std::vector<FitLattice> lattices = setup_.evenLattices();
        KnotPlan plan = setup_.firstKnots(lattices, share_);
        state_.begin(std::move(plan), std::move(lattices), slides_);
        maxPoints_ = maxGrowth * state_.score().controlPoints;
        for (const Segment& segment : setup_.layout.segments)
            maxPoints_ += maxPerQuad * segment.faces.size();
    }

    void unfold(const std::function<bool()>& isStopRequested) {
        const int maxTimes = setup_.options.unfoldings;
        for (int times = 0; times < maxTimes && state_.errors().isAnyFolded(); ++times) {
            if (state_.score().controlPoints > maxPoints_) break;
            std::optional<KnotPlan> plan;
            if (times < maxTimesCloser) {
                plan = closerKnots();
                if (!plan) continue;
            }
            if (isStopRequested()) return;
            if (plan)
                state_.takeKnots(std::move(*plan));
            else if (!refine())
                break;
            state_.beginAnew(slides_);
        }
        if (maxTimes == 0 || !state_.errors().isAnyFolded() || isStopRequested()) return;
        // Something else makes them fold.
        forFolded([](double& share) { share = 1; });
        state_.takeKnots(knots());
        state_.beginAnew(slides_);
    }

private:
    template <class Function> void forFolded(const Function& function) {
        const std::vector<bool> folded = state_.errors().areFolded();
        for (std::size_t k = 0; k < folded.size(); ++k)
            if (folded[k]) function(share_[k]);
    }

    [[nodiscard]] KnotPlan knots() const { return setup_.firstKnots(setup_.evenLattices(), share_); }

    /// More first knots where patches fold.
    /// \return nothing if patches have begun anew with these, and would fold in the same way
    std::optional<KnotPlan> closerKnots() {
        forFolded([](double& share) { share *= closer; });
        KnotPlan plan = knots();
        std::vector<bool> folded = state_.errors().areFolded();
        const bool hasSameKnots = state_.isSolvedWith(plan);
        if (hasSameKnots && folded == begunFor_) return std::nullopt;
        begunFor_ = hasSameKnots ? std::move(folded) : std::vector<bool>{};
        return plan;
    }

    bool refine() {
        const auto allowShorter = [&] {
            return state_.allow(MinInterval::eighth) || state_.allow(MinInterval::thirtySecond);
        };
        return state_.refine() || (allowShorter() && state_.refine());
    }

    FitState& state_;
    const FitSetup& setup_;
    int slides_;
    std::vector<double> share_;    ///< by patch: of the usual distances between the first knots
    std::size_t maxPoints_ = 0;    ///< of control points with which patches still begin anew
    std::vector<bool> begunFor_{}; ///< those folded when patches began anew with the knots they had
};

} // namespace

void solveFirst(FitState& state, int slides, const std::function<bool()>& isStopRequested) {
    FirstSolution first(state, slides);
    first.solve();
    first.unfold(isStopRequested);
}

} // namespace qm
