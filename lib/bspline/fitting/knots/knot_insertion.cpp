#include "bspline/fitting/knots/knot_insertion.h"

#include "bspline/fitting/knots/initial_knots.h"
#include "bspline/fitting/lattice/lattice_cells.h"
#include "bspline/splines/basis.h"
#include "layout/sides.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

class Refinement {
public:
    Refinement(const std::vector<FitLattice>& lattices, const StretchMap& map,
               const std::vector<PatchSpace>& spaces, const std::vector<PatchErrors>& errors, KnotPlan& plan)
        : lattices_(lattices), map_(map), spaces_(spaces), errors_(errors), plan_(plan) {
        measureNeighbourhoods();
    }

    bool run() {
        for (std::size_t run = 0; run < plan_.runs().size(); ++run)
            for (std::size_t end = 0; end < 2; ++end)
                shortenIfNeeded({run, end});
        for (std::size_t patch = 0; patch < lattices_.size(); ++patch)
            for (const KnotCell& cell : cellsOf(spaces_[patch]))
                divideCell(patch, cell);
        return changed_;
    }

private:
    /// Determines for every patch the error above which it is refined.
    void measureNeighbourhoods() {
        constexpr double share = 0.5;
        std::vector<double> own;
        for (const PatchErrors& ofPatch : errors_)
            own.push_back(ofPatch.max());
        limits_ = own;
        for (const Stretch& stretch : plan_.stretches()) {
            const std::size_t a = stretch.sides[0].patch;
            const std::size_t b = stretch.sides[1].patch;
            limits_[a] = std::max(limits_[a], own[b]);
            limits_[b] = std::max(limits_[b], own[a]);
        }
        for (double& limit : limits_)
            limit = std::max(1.0, share * limit);
    }

    /// The part of a border along which a tangent ratio does not vanish.
    [[nodiscard]] KnotCell along(const StretchSide& place, double x, double reach) const {
        const auto& size = plan_.sizes()[place.patch];
        const auto [begin, end] =
            std::minmax({patchPlace(size, place, x), patchPlace(size, place, x + reach)});
        return {begin, end}; // one of both coordinates is the same
    }

    void shortenIfNeeded(const RunEnd& end) {
        const SmoothRun& run = plan_.runs()[end.run];
        if (run.ratio.atEnd[end.end] == 0) return;
        const double reach = run.ratio.reach[end.end];
        const double x = end.end == 0 ? run.begin : run.end - reach;
        for (const StretchSide& place : plan_.stretches()[run.stretch].sides) {
            const WorstPoint worst =
                worstIn(along(place, x, reach), lattices_[place.patch], errors_[place.patch]);
            if (worst.error <= limits_[place.patch]) continue;
            changed_ = plan_.shorten(end) || changed_;
            return;
        }
    }

    void divideCell(std::size_t patch, const KnotCell& cell) {
        const WorstPoint worst = worstIn(cell, lattices_[patch], errors_[patch]);
        if (worst.error <= limits_[patch]) return;
        constexpr double negligible = 0.5; // relative to the variation in the other direction
        const auto varied = variation(cell, lattices_[patch], errors_[patch]);
        const auto canDivide = [&](std::size_t d) { return cell.length(d) > plan_.minInterval(patch, d); };
        // Only knots along a border bring the border nearer to the reference.
        const auto helps = [&](std::size_t d) {
            const bool isAlong = isOnBorder(patch, d, worst);
            const bool isAcross = isOnBorder(patch, 1 - d, worst);
            if (isAlong != isAcross && !worst.isFolded) return isAlong;
            return varied[d] >= negligible * varied[1 - d];
        };
        for (const std::size_t d : {0U, 1U})
            if (helps(d) || !canDivide(1 - d)) divideAlong(patch, d, cell, worst);
    }

    /// Whether a place is on a side that runs in this direction.
    [[nodiscard]] bool isOnBorder(std::size_t patch, std::size_t direction, const WorstPoint& worst) const {
        const double across = worst.at[1 - direction];
        return across == 0 || across == plan_.sizes()[patch][1 - direction];
    }

    /// Divides the cell's interval, or the interval of a neighbour beside it where that is longer.
    void divideAlong(std::size_t patch, std::size_t direction, const KnotCell& cell,
                     const WorstPoint& worst) {
        const auto& size = plan_.sizes()[patch];
        const std::size_t other = 1 - direction;
        const double own = cell.length(direction);
        bool isOwnNeeded = true;
        for (const bool isFar : {false, true}) {
            const double border = isFar ? size[other] : 0;
            if (border != (isFar ? cell.end[other] : cell.begin[other])) continue;
            const auto across = map_.across(patch, sideAcross(other, isFar), worst.at[direction]);
            if (!across) continue;
            const bool isOnBorder = worst.at[other] == border;
            if (!isOnBorder && !across->isSmooth) continue;
            const auto& knots = spaces_[across->patch].knots[across->direction];
            const std::size_t span = knotSpan(knots, 3, across->parameter);
            const double length = knots[span + 1] - knots[span];
            if (length < own || (length == own && !isOnBorder)) continue;
            divide(across->patch, across->direction, knots[span], knots[span + 1]);
            if (length > own && isOnBorder) isOwnNeeded = false;
        }
        if (isOwnNeeded) divide(patch, direction, cell.begin[direction], cell.end[direction]);
    }

    /// Inserts a knot near the middle of an interval, at a neighbour's knot or a grid line if possible.
    void divide(std::size_t patch, std::size_t direction, double begin, double end) {
        const double length = end - begin;
        if (length <= plan_.minInterval(patch, direction)) return;
        double knot = length >= 2 ? std::floor((begin + end) / 2) : (begin + end) / 2;
        double nearest = 0.25 * length;
        for (const double beside : knotsBeside(map_, plan_, patch, direction)) {
            const double off = std::abs(beside - (begin + end) / 2);
            if (off >= nearest) continue;
            nearest = off;
            knot = beside;
        }
        changed_ = plan_.insert(patch, direction, knot) || changed_;
    }

    const std::vector<FitLattice>& lattices_;
    const StretchMap& map_;
    const std::vector<PatchSpace>& spaces_;
    const std::vector<PatchErrors>& errors_;
    KnotPlan& plan_;
    std::vector<double> limits_;
    bool changed_ = false;
};

} // namespace

bool refine(const std::vector<FitLattice>& lattices, const StretchMap& map,
            const std::vector<PatchSpace>& spaces, const std::vector<PatchErrors>& errors, KnotPlan& plan) {
    return Refinement(lattices, map, spaces, errors, plan).run();
}

} // namespace qm
