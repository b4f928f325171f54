#include "bspline/fitting/smooth_fit.h"

#include "base/parallel.h"
#include "bspline/fitting/fit_lattice.h"
#include "bspline/fitting/initial_knots.h"
#include "bspline/fitting/knot_insertion.h"
#include "bspline/fitting/knot_removal.h"
#include "bspline/fitting/smooth_system.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace qm {
namespace {

/// A spline is farther from a function than single cubics over its intervals, by this share.
constexpr double cubicsShare = 0.2;

/// Errors that removals may come to; what is near 1 comes back.
constexpr double removalLimit = 0.9;

constexpr int maxRounds = 25;
constexpr int maxRemovals = 3;

class SmoothFit {
public:
    SmoothFit(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
              const std::vector<ReferenceGrid>& reference, const SmoothFitOptions& options, unsigned jobs)
        : layout_(layout), options_(options), jobs_(jobs), map_(mesh, layout, network),
          plan_(layout, network), lattices_(fitLattices(mesh, layout, network, reference)) {
        insertInitialKnots(layout, lattices_, map_, cubicsShare * options.tolerance, plan_);
        plan_.endAtFirstKnots();
    }

    std::vector<Patch> run(const Control& control) {
        int removals = 0;
        for (int round = 0; round < maxRounds; ++round) {
            control.progress(static_cast<double>(round) / maxRounds);
            solve();
            keepIfBest();
            if (worst_ <= 1 && removals < maxRemovals) {
                ++removals;
                if (removeKnots(lattices_, patches_, errors_, options_.tolerance, removalLimit, plan_) == 0)
                    break;
            } else {
                const bool canWeigh = weighWhatIsMissed();
                if (!refine(layout_, lattices_, map_, spaces_, errors_, plan_) && !canWeigh) break;
            }
        }
        return std::move(best_);
    }

private:
    void solve() {
        spaces_ = plan_.spaces();
        patches_ = solveSmooth(layout_, plan_.network(), spaces_, lattices_, options_.bending, jobs_);
        errors_.resize(patches_.size());
        parallelFor(patches_.size(), jobs_, [&](std::size_t k) {
            errors_[k] = errors(lattices_[k], patches_[k], options_.tolerance);
        });
        worst_ = 0;
        for (const auto& ofPatch : errors_)
            worst_ = std::max(worst_, std::ranges::max(ofPatch));
    }

    /// Gives points that are too far away more weight, so that the largest error counts and not the mean.
    /// \return false if no weight can grow any more
    bool weighWhatIsMissed() {
        constexpr double growth = 3;
        constexpr double max = 100; // times the first weight
        bool changed = false;
        for (std::size_t k = 0; k < lattices_.size(); ++k) {
            const double first = 1.0 / (lattices_[k].steps * lattices_[k].steps);
            for (std::size_t i = 0; i < errors_[k].size(); ++i) {
                double& weight = lattices_[k].targets.weights[i];
                if (errors_[k][i] <= 1 || weight >= max * first) continue;
                weight *= growth;
                changed = true;
            }
        }
        return changed;
    }

    /// Within the tolerance the fewest control points are best, else the smallest error.
    void keepIfBest() {
        const bool keeps = worst_ <= 1;
        const bool bestKeeps = bestWorst_ <= 1;
        const bool isBetter =
            best_.empty() || keeps != bestKeeps
                ? best_.empty() || keeps
                : (keeps ? controlPointCount(patches_) < controlPointCount(best_) : worst_ < bestWorst_);
        if (!isBetter) return;
        best_ = patches_;
        bestWorst_ = worst_;
    }

    const Layout& layout_;
    const SmoothFitOptions& options_;
    unsigned jobs_;
    StretchMap map_;
    KnotPlan plan_;
    std::vector<FitLattice> lattices_;
    std::vector<PatchSpace> spaces_;
    std::vector<Patch> patches_;
    LatticeErrors errors_;
    double worst_ = 0;
    std::vector<Patch> best_;
    double bestWorst_ = 0;
};

} // namespace

std::vector<Patch> fitSmooth(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
                             const std::vector<ReferenceGrid>& reference, const SmoothFitOptions& options,
                             const Control& control) {
    return SmoothFit(mesh, layout, network, reference, options, control.jobs).run(control);
}

} // namespace qm
