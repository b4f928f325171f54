#include "bspline/patch_fit.h"

#include "bspline/faceted_patch.h"
#include "bspline/patch_solver.h"

#include <algorithm>
#include <optional>

namespace qm {
namespace {

/// What the patch needs so that its border is that of the curves: their knots, or their degree where there
/// are none inside.
Knots borderKnots(const PatchFitInput& input) {
    Knots knots;
    for (std::size_t d = 0; d < 2; ++d) {
        const auto& [one, other] = input.border[d];
        const auto degree = static_cast<std::size_t>(std::max(one.degree, other.degree));
        knots[d] = commonKnots(one.knots, other.knots);
        if (degree == 3) continue;
        knots[d].assign(degree + 1, 0);
        knots[d].insert(knots[d].end(), degree + 1, one.length());
    }
    return knots;
}

/// Takes out knots for as long as the patch still fits; in a large patch, some.
PatchAttempt withoutNeedlessKnots(const PatchSolver& solver, PatchAttempt best, const Knots& needed) {
    constexpr int effort = 3000; // control points of all attempts together
    int left = effort / static_cast<int>(best.patch.controlPoints.size());
    for (std::size_t d = 0; d < 2; ++d)
        for (std::size_t k = 4; k + 4 < best.patch.knots[d].size();) {
            Knots fewer = best.patch.knots;
            fewer[d].erase(fewer[d].begin() + static_cast<std::ptrdiff_t>(k));
            if (!std::includes(fewer[d].begin(), fewer[d].end(), needed[d].begin(), needed[d].end())) {
                ++k;
                continue;
            }
            if (left-- <= 0) return best;
            PatchAttempt simpler = solver.attempt(fewer, true);
            if (simpler.largest <= 1)
                best = std::move(simpler);
            else
                ++k;
        }
    return best;
}

/// None if knots are wanted where there can be no more, or so many that to follow the facets takes fewer, or
/// that it takes too long.
std::optional<PatchAttempt> refined(const PatchSolver& solver, Knots knots, bool aimsAtNormals,
                                    const std::array<KnotRules, 2>& rules, std::size_t most) {
    while (!aimsAtNormals || PatchSolver::isQuick(knots)) {
        PatchAttempt attempt = solver.attempt(knots, aimsAtNormals);
        if (attempt.largest <= 1) return attempt;
        std::array<KnotRefinement, 2> refinement = {KnotRefinement(knots[0], rules[0]),
                                                    KnotRefinement(knots[1], rules[1])};
        solver.mark(attempt, refinement);
        const Knots more = {refinement[0].enriched(), refinement[1].enriched()};
        if (more == knots || more[0].size() * more[1].size() > most) return std::nullopt;
        knots = more;
    }
    return std::nullopt;
}

Patch smoothest(const PatchSolver& solver, PatchAttempt known) {
    auto smoother = solver.smoothest(known.patch.knots, known.patch);
    return smoother ? std::move(smoother->patch) : std::move(known.patch);
}

} // namespace

Patch fitPatch(const PatchFitInput& input, double tolerance) {
    const PatchSolver solver(input, tolerance, input.closeness);
    const Knots needed = borderKnots(input);
    const auto edges = [&](std::size_t d) { return static_cast<std::size_t>(input.size[d]); };
    const std::size_t most = 4 * (edges(0) + 7) * (edges(1) + 7);
    const auto& sharp = solver.samples().sharpLines();
    auto found =
        refined(solver, needed, true,
                {KnotRules{finestKnots, true, sharp[0]}, KnotRules{finestKnots, true, sharp[1]}}, most);
    if (found) return smoothest(solver, withoutNeedlessKnots(solver, std::move(*found), needed));
    // Closeness goes before smoothness. Without sliding, the coordinates are independent: that is fast.
    const PatchSolver close(input, tolerance, {});
    found = refined(close, needed, false, {}, (3 * edges(0) + 5) * (3 * edges(1) + 5));
    return found ? smoothest(close, std::move(*found)) : facetedPatch(input);
}

} // namespace qm
