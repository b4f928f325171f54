#include "bspline/fitting/knot_insertion.h"

#include "bspline/fitting/initial_knots.h"
#include "bspline/splines/basis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace qm {
namespace {

/// A rectangle of parameters, by direction.
struct Cell {
    std::array<double, 2> begin{};
    std::array<double, 2> end{};

    [[nodiscard]] double length(std::size_t direction) const { return end[direction] - begin[direction]; }
};

/// The part of a lattice over a cell, ends included.
struct LatticeRange {
    std::array<int, 2> begin{};
    std::array<int, 2> end{};
};

LatticeRange rangeOf(const Cell& cell, int steps) {
    LatticeRange range;
    for (std::size_t d = 0; d < 2; ++d) {
        range.begin[d] = static_cast<int>(std::ceil(cell.begin[d] * steps));
        range.end[d] = static_cast<int>(std::floor(cell.end[d] * steps));
    }
    return range;
}

struct Worst {
    double error = 0;
    std::array<double, 2> at{};
};

Worst worstIn(const Cell& cell, const FitLattice& lattice, const std::vector<double>& errors) {
    const LatticeRange range = rangeOf(cell, lattice.steps);
    Worst worst;
    for (int j = range.begin[1]; j <= range.end[1]; ++j)
        for (int i = range.begin[0]; i <= range.end[0]; ++i) {
            const double error =
                errors[static_cast<std::size_t>(j) * lattice.columns() + static_cast<std::size_t>(i)];
            if (error <= worst.error) continue;
            worst.error = error;
            worst.at = {static_cast<double>(i) / lattice.steps, static_cast<double>(j) / lattice.steps};
        }
    return worst;
}

/// Largest third difference of the reference along each direction of a cell, in steps of a quarter of it.
std::array<double, 2> roughness(const Cell& cell, const FitLattice& lattice) {
    const LatticeRange range = rangeOf(cell, lattice.steps);
    std::array<int, 2> step{};
    for (std::size_t d = 0; d < 2; ++d)
        step[d] = std::max(1, (range.end[d] - range.begin[d]) / 4);
    const auto index = [&](int i, int j) {
        return static_cast<std::size_t>(j) * lattice.columns() + static_cast<std::size_t>(i);
    };
    const auto& points = lattice.targets.points;
    std::array<double, 2> result{};
    for (int j = range.begin[1]; j <= range.end[1]; ++j)
        for (int i = range.begin[0]; i <= range.end[0]; ++i)
            for (std::size_t d = 0; d < 2; ++d) {
                if ((d == 0 ? i : j) + 3 * step[d] > range.end[d]) continue;
                const auto at = [&](int k) {
                    return points[index(d == 0 ? i + k * step[0] : i, d == 1 ? j + k * step[1] : j)];
                };
                const Point third = at(3) - at(0) + 3.0 * (at(1) - at(2));
                result[d] = std::max(result[d], distance(lattice, index(i, j), third));
            }
    return result;
}

class Refinement {
public:
    Refinement(const Layout& layout, const std::vector<FitLattice>& lattices, const StretchMap& map,
               const std::vector<PatchSpace>& spaces, const LatticeErrors& errors, KnotPlan& plan)
        : layout_(layout), lattices_(lattices), map_(map), spaces_(spaces), errors_(errors), plan_(plan) {
        measureNeighbourhoods();
    }

    bool run() {
        for (std::size_t run = 0; run < plan_.network().runs.size(); ++run)
            for (std::size_t end = 0; end < 2; ++end)
                shortenIfNeeded(run, end);
        for (std::size_t patch = 0; patch < lattices_.size(); ++patch)
            dividePatch(patch);
        return changed_;
    }

private:
    /// The error from which on a patch is refined.
    void measureNeighbourhoods() {
        constexpr double share = 0.3;
        std::vector<double> own;
        for (const auto& ofPatch : errors_)
            own.push_back(std::ranges::max(ofPatch));
        limits_ = own;
        for (const Stretch& stretch : plan_.network().stretches) {
            const std::size_t a = stretch.sides[0].patch;
            const std::size_t b = stretch.sides[1].patch;
            limits_[a] = std::max(limits_[a], own[b]);
            limits_[b] = std::max(limits_[b], own[a]);
        }
        for (double& limit : limits_)
            limit = std::max(1.0, share * limit);
    }

    /// What lies beside the part of a border along which a tangent ratio is not zero.
    [[nodiscard]] Cell beside(const StretchSide& place, double x, double reach) const {
        const auto& size = layout_.segments[place.patch].size;
        const std::size_t along = directionAlong(place.side);
        const double a = patchParameter(size, place, x);
        const double b = patchParameter(size, place, x + reach);
        const double depth = std::min<double>(std::max(1.0, reach), size[1 - along]);
        Cell cell;
        cell.begin[along] = std::min(a, b);
        cell.end[along] = std::max(a, b);
        const bool isFar = place.side == 1 || place.side == 2;
        cell.begin[1 - along] = isFar ? size[1 - along] - depth : 0;
        cell.end[1 - along] = isFar ? size[1 - along] : depth;
        return cell;
    }

    void shortenIfNeeded(std::size_t index, std::size_t end) {
        const SmoothRun& run = plan_.network().runs[index];
        if (run.ratio.atEnd[end] == 0) return;
        const double reach = run.ratio.reach[end];
        const double x = end == 0 ? run.begin : run.end - reach;
        for (const StretchSide& place : plan_.network().stretches[run.stretch].sides) {
            const Worst worst =
                worstIn(beside(place, x, reach), lattices_[place.patch], errors_[place.patch]);
            if (worst.error <= limits_[place.patch]) continue;
            changed_ = plan_.shorten(index, end) || changed_;
            return;
        }
    }

    void dividePatch(std::size_t patch) {
        const auto& knots = spaces_[patch].knots;
        for (std::size_t a = 3; a + 4 < knots[0].size(); ++a)
            for (std::size_t b = 3; b + 4 < knots[1].size(); ++b) {
                const Cell cell{{knots[0][a], knots[1][b]}, {knots[0][a + 1], knots[1][b + 1]}};
                if (cell.length(0) > 0 && cell.length(1) > 0) divideCell(patch, cell);
            }
    }

    void divideCell(std::size_t patch, const Cell& cell) {
        const Worst worst = worstIn(cell, lattices_[patch], errors_[patch]);
        if (worst.error <= limits_[patch]) return;
        constexpr double negligible = 1.0 / 3; // of the other direction's roughness
        const auto rough = roughness(cell, lattices_[patch]);
        for (std::size_t d = 0; d < 2; ++d)
            if (rough[d] >= negligible * rough[1 - d] || cell.length(1 - d) <= KnotPlan::minInterval)
                divideAlong(patch, d, cell, worst);
    }

    /// Divides the cell, or what its neighbours have beside it where that is longer.
    void divideAlong(std::size_t patch, std::size_t direction, const Cell& cell, const Worst& worst) {
        const auto& size = layout_.segments[patch].size;
        const std::size_t other = 1 - direction;
        const double own = cell.length(direction);
        bool isOwnNeeded = true;
        for (const bool isFar : {false, true}) {
            const double border = isFar ? size[other] : 0;
            if (border != (isFar ? cell.end[other] : cell.begin[other])) continue;
            const int side = direction == 0 ? (isFar ? 2 : 0) : (isFar ? 1 : 3);
            const auto across = map_.across(patch, side, worst.at[direction]);
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

    /// Inserts a knot near the middle of an interval: one that a neighbour has, or a grid line.
    void divide(std::size_t patch, std::size_t direction, double begin, double end) {
        const double length = end - begin;
        if (length <= KnotPlan::minInterval) return;
        double knot = length >= 2 ? std::floor((begin + end) / 2) : (begin + end) / 2;
        double nearest = 0.25 * length;
        for (const double beside : knotsBeside(layout_, map_, plan_, patch, direction)) {
            const double off = std::abs(beside - (begin + end) / 2);
            if (off >= nearest) continue;
            nearest = off;
            knot = beside;
        }
        changed_ = plan_.insert(patch, direction, knot) || changed_;
    }

    const Layout& layout_;
    const std::vector<FitLattice>& lattices_;
    const StretchMap& map_;
    const std::vector<PatchSpace>& spaces_;
    const LatticeErrors& errors_;
    KnotPlan& plan_;
    std::vector<double> limits_;
    bool changed_ = false;
};

} // namespace

bool refine(const Layout& layout, const std::vector<FitLattice>& lattices, const StretchMap& map,
            const std::vector<PatchSpace>& spaces, const LatticeErrors& errors, KnotPlan& plan) {
    return Refinement(layout, lattices, map, spaces, errors, plan).run();
}

} // namespace qm
