#include "bspline/fitting/knots/knot_removal.h"

#include "base/positions.h"
#include "bspline/splines/evaluate.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

/// Knots are removed only if the errors stay below this; errors closer to 1 would bring the knots back.
constexpr double limit = 0.9;

/// A patch, and what decides on its knots.
struct FittedPatch {
    const FitLattice& lattice;
    const NormalLimits& limits;
    const Patch& patch;
    const PatchErrors& errors;
    double tolerance;
};

/// The third derivatives of a patch within one knot interval, by line across it.
std::vector<Point> thirdDerivatives(const Patch& patch, std::size_t direction, double begin, double end,
                                    const std::vector<double>& lines) {
    // First derivatives are quadratic in the interval, so second differences are exact.
    const double step = (end - begin) / 4;
    const std::vector<double> along{begin + step, begin + 2 * step, begin + 3 * step};
    const auto points =
        direction == 0 ? evaluateLattice(patch, along, lines) : evaluateLattice(patch, lines, along);
    std::vector<Point> result;
    for (std::size_t line = 0; line < lines.size(); ++line) {
        const auto slope = [&](std::size_t k) {
            return direction == 0 ? points[line * 3 + k].du : points[k * lines.size() + line].dv;
        };
        result.push_back((slope(0) - 2.0 * slope(1) + slope(2)) / (step * step));
    }
    return result;
}

/// Predicts the largest error around a knot if it is removed: of distances in tolerances, and of slopes
/// relative to their limits.
double errorWithout(const FittedPatch& fitted, std::size_t direction, std::size_t knot) {
    const auto& [lattice, limits, patch, errors, tolerance] = fitted;
    // Deflection and slope of a beam under a load in its middle; the deflection lies between those for
    // clamped and for free ends.
    constexpr double deflection = 1.0 / 150;
    constexpr double slope = 4;
    const auto& knots = patch.knots[direction];
    const auto& lines = lattice.targets.parameters[1 - direction];
    const auto before = thirdDerivatives(patch, direction, knots[knot - 1], knots[knot], lines);
    const auto after = thirdDerivatives(patch, direction, knots[knot], knots[knot + 1], lines);
    const double length = knots[knot + 1] - knots[knot - 1];
    const double scale = deflection * length * length * length;
    const auto& parameters = lattice.targets.parameters[direction];
    const auto step = [&](double parameter) {
        return positionIn(parameters, std::ranges::lower_bound(parameters, parameter));
    };
    double worst = 0;
    for (std::size_t line = 0; line < lines.size(); ++line) {
        const std::size_t middle = lattice.onLine(direction, line, step(knots[knot]));
        const double added = scale * distance(lattice, middle, after[line] - before[line]);
        worst = std::max(worst, slope * added / (length * lattice.edge[middle]) /
                                    limits.at(lattice, direction, line, step(knots[knot])));
        for (std::size_t along = step(knots[knot - 1]); along <= step(knots[knot + 1]); ++along)
            worst = std::max(worst, errors.error[lattice.onLine(direction, line, along)] + added / tolerance);
    }
    return worst;
}

} // namespace

std::vector<PatchKnot> removeKnots(const std::vector<FitLattice>& lattices,
                                   const std::vector<NormalLimits>& limits, const std::vector<Patch>& patches,
                                   const std::vector<PatchErrors>& errors, double tolerance, KnotPlan& plan) {
    std::vector<PatchKnot> removed;
    for (std::size_t patch = 0; patch < patches.size(); ++patch) {
        const FittedPatch fitted{lattices[patch], limits[patch], patches[patch], errors[patch], tolerance};
        for (const std::size_t direction : {0U, 1U}) {
            const auto& knots = patches[patch].knots[direction];
            std::vector<std::pair<double, std::size_t>> candidates;
            for (const double chosen : plan.chosen(patch, direction)) {
                if (std::ranges::count(knots, chosen) != 1) continue;
                const std::size_t knot = positionIn(knots, std::ranges::find(knots, chosen));
                const double error = errorWithout(fitted, direction, knot);
                if (error < limit) candidates.emplace_back(error, knot);
            }
            std::ranges::sort(candidates);
            std::vector<bool> isGone(knots.size());
            for (const auto& [error, knot] : candidates) {
                if (isGone[knot - 1] || isGone[knot + 1]) continue;
                isGone[knot] = true;
                plan.erase(patch, direction, knots[knot]);
                removed.push_back({patch, direction, knots[knot]});
            }
        }
    }
    return removed;
}

} // namespace qm
