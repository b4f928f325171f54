#include "bspline/patch_smoothing.h"

#include "bspline/patch_solver.h"

#include <utility>

namespace qm {
namespace {

/// What the sum of squares has to fall to, so that a change is worth while.
constexpr double worthwhile = 0.98;
constexpr double worthKnots = 0.95;

/// The knots of a patch and one more, where its normals are farthest off.
std::optional<Knots> withOneMore(const PatchFitInput& input, const Patch& patch, const NormalErrors& errors,
                                 bool beside) {
    const std::size_t d = beside ? 1 - errors.direction : errors.direction;
    const double at = !beside ? errors.at : errors.end == 0 ? 0 : input.size[d];
    KnotRefinement refinement(patch.knots[d], {finestKnots, false, {}});
    if (!refinement.canRefine(at)) return std::nullopt;
    refinement.addError(at, 1);
    Knots knots = patch.knots;
    knots[d] = refinement.enriched();
    return knots;
}

std::optional<Patch> fitted(const PatchSolver& solver, const Knots& knots, const Patch& known) {
    if (auto smoothest = solver.smoothest(knots, known)) return std::move(smoothest->patch);
    PatchAttempt attempt = solver.attempt(knots, true);
    if (attempt.largest > 1) return std::nullopt;
    return std::move(attempt.patch);
}

} // namespace

NormalErrors normalErrors(const PatchFitInput& input, const Patch& patch) {
    const auto angles = anglesOff(input.normals, input.border, patch);
    NormalErrors errors;
    for (std::size_t d = 0; d < 2; ++d) {
        const auto parameters = normalParameters(input.size[d]);
        for (std::size_t end = 0; end < 2; ++end)
            for (std::size_t k = 0; k < angles[d][end].size(); ++k) {
                const double angle = angles[d][end][k];
                errors.squares += angle * angle;
                if (angle <= errors.largest) continue;
                errors.largest = angle;
                errors.direction = d;
                errors.end = end;
                errors.at = parameters[k];
            }
    }
    return errors;
}

SmoothedPatch smoothPatch(const PatchFitInput& input, double tolerance, const Patch& known, double enough,
                          bool mayGrow) {
    SmoothedPatch result;
    NormalErrors errors = normalErrors(input, known);
    if (errors.largest <= enough) return result;
    const PatchSolver solver(input, tolerance, input.closeness);
    if (auto next = fitted(solver, known.knots, known)) {
        const NormalErrors left = normalErrors(input, *next);
        if (left.squares < worthwhile * errors.squares) {
            errors = left;
            result.sameKnots = std::move(next);
        }
    }
    if (errors.largest <= enough || !mayGrow) return result;
    const Patch& best = result.sameKnots ? *result.sameKnots : known;
    for (const bool beside : {false, true}) {
        const auto knots = withOneMore(input, best, errors, beside);
        if (!knots) continue;
        auto next = fitted(solver, *knots, known);
        if (!next || next->controlPoints.size() <= best.controlPoints.size()) continue;
        const double left = normalErrors(input, *next).squares;
        const auto more = static_cast<double>(next->controlPoints.size() - best.controlPoints.size());
        const double gain = (errors.squares - left) / more;
        if (!(left < worthKnots * errors.squares) || !(gain > result.gain)) continue;
        result.gain = gain;
        result.oneMoreKnot = std::move(next);
    }
    return result;
}

} // namespace qm
