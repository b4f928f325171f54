#include "bspline/measure/foot_search.h"

#include "base/infinity.h"
#include "layout/sides.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace qm {
namespace {

constexpr int maxIterations = 24; ///< of less than a whole quad: a limit for what does not converge
constexpr int maxHalvings = 4;
constexpr int maxCrossings = 6;  ///< enough to go around a vertex, and an end to going round and round
constexpr double maxStep = 1;    // quads
constexpr double minStep = 1e-6; ///< of a quad; distances then differ by its square

/// Where a step towards a point leads.
struct Step {
    Parameters to{};
    int side = -1;        ///< of the patch, if the step would lead beyond it
    bool isWhole = false; ///< as long as it may be: the point is farther away
};

/// \param extent  the patch's range in either direction begins at 0 and ends here
Step gaussNewton(const PiecePoint& here, const Eigen::Vector3d& away, const Parameters& at,
                 const Parameters& extent) {
    const double uu = here.du.squaredNorm();
    const double uv = here.du.dot(here.dv);
    const double vv = here.dv.squaredNorm();
    const double ru = here.du.dot(away);
    const double rv = here.dv.dot(away);
    const double determinant = uu * vv - uv * uv;
    const auto alone = [](double slope, double square) { return square > 0 ? slope / square : 0.0; };
    Parameters step{alone(ru, 2 * uu), alone(rv, 2 * vv)};
    if (determinant > 1e-10 * uu * vv)
        step = {(ru * vv - rv * uv) / determinant, (rv * uu - ru * uv) / determinant};
    const double longest = std::max(std::abs(step[0]), std::abs(step[1]));
    Step result;
    result.isWhole = longest > maxStep;
    double overshoot = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        if (result.isWhole) step[k] *= maxStep / longest; // in the same direction, which leads nearer
        result.to[k] = at[k] + step[k];
        const double beyond = std::max(-result.to[k], result.to[k] - extent[k]);
        if (beyond <= overshoot) continue;
        overshoot = beyond;
        result.side = sideAcross(k, result.to[k] > 0);
    }
    if (result.side < 0) return result;
    // On the border the other parameter alone is free.
    const std::size_t across = directionAcross(result.side);
    result.to[across] = isFarSide(result.side) ? extent[across] : 0;
    const double moved = result.to[across] - at[across];
    const double along = across == 0 ? alone(rv - uv * moved, vv) : alone(ru - uv * moved, uu);
    const double free = at[1 - across] + std::clamp(along, -maxStep, maxStep);
    result.to[1 - across] = std::clamp(free, 0.0, extent[1 - across]);
    return result;
}

/// Where a walk is, and where it has been.
struct Walk {
    const PairedSurfaces& surfaces;
    int& crossings; ///< that are left
    LayoutPlace place;
    int turns = 0;
    Foot best{};                         ///< the nearest place so far
    std::optional<LayoutPlace> border{}; ///< of the patch that was left with the last step
    int halvings = 0;                    ///< of the last step
    bool isOverLine = false;             ///< the last step led just over a mesh line

    /// Takes a step from the nearest place so far, if need be across a border.
    /// \return false if it hardly moves
    bool goOn(const Step& step) {
        halvings = 0;
        isOverLine = false;
        border.reset();
        const double moved = std::hypot(step.to[0] - place.at[0], step.to[1] - place.at[1]);
        place.at = step.to;
        const auto crossing =
            step.side >= 0 && crossings > 0 ? surfaces.across(place, step.side) : std::nullopt;
        if (!crossing) return !(moved < minStep);
        --crossings;
        border = std::exchange(place, crossing->to);
        turns = (turns + crossing->turns) % 4;
        return true;
    }

    /// Takes back some of a step that has not led nearer.
    /// \return false if it has been halved too often
    bool goBack() {
        if (border) {
            // What lies beyond is farther away: only the border remains.
            place = *border;
            turns = best.turns;
            border.reset();
            crossings = 0;
            return true;
        }
        if (++halvings > maxHalvings) return false;
        const auto toLine = halvings == 1 ? shareToLine() : std::nullopt;
        isOverLine = toLine.has_value();
        const double share = toLine.value_or(0.5);
        for (std::size_t d = 0; d < 2; ++d)
            place.at[d] = best.place.at[d] + share * (place.at[d] - best.place.at[d]);
        return true;
    }

    /// The share of the last step that leads just over the first mesh line on its way, if there is one: quads
    /// beyond may be far wider, and the step has been measured by those on this side.
    [[nodiscard]] std::optional<double> shareToLine() const {
        constexpr double just = 1e-9; // of a quad
        std::optional<double> share;
        for (std::size_t d = 0; d < 2; ++d) {
            const double from = best.place.at[d];
            const double way = place.at[d] - from;
            if (way == 0) continue;
            // A place on a line is in the quad beyond.
            const double line = std::floor(from) + (way > 0 ? 1 : 0);
            const double toLine = (line + std::copysign(just, way) - from) / way;
            if (toLine < share.value_or(1)) share = toLine;
        }
        return share;
    }
};

} // namespace

PiecePoint FootSearch::evaluateAt(std::size_t surface, const LayoutPlace& place) {
    const Cell cell = surfaces_.cellAt(place);
    Parameters local{};
    Parameters width{};
    const ParameterBox box = surfaces_.box(cell);
    for (std::size_t k = 0; k < 2; ++k) {
        const auto [from, to] = box[k];
        width[k] = to - from;
        local[k] = (place.at[k] - from) / width[k];
    }
    PiecePoint here = evaluate(piece_(surface, cell), local[0], local[1]);
    here.du /= width[0];
    here.dv /= width[1];
    return here;
}

Foot FootSearch::operator()(std::size_t surface, const LayoutPlace& start, const Eigen::Vector3d& point) {
    int crossings = maxCrossings;
    const Foot found = walk(surface, start, point, crossings);
    Foot best = found;
    const auto tryFrom = [&](const LayoutPlace& place, int turns) {
        int none = 0;
        Foot foot = walk(surface, place, point, none);
        if (!(foot.distance < best.distance)) return;
        best = foot;
        best.turns = turns;
    };
    // What is nearest on one side of a border may not be on the other: at a crease, or to and fro over it.
    bool isOnBorder = false;
    for (int side = 0; side < 4; ++side) {
        const std::size_t across = directionAcross(side);
        const double border = isFarSide(side) ? surfaces_.extent(found.place.patch)[across] : 0;
        if (std::abs(found.place.at[across] - border) > minStep) continue;
        isOnBorder = true;
        const auto crossing = surfaces_.across(found.place, side);
        if (crossing) tryFrom(crossing->to, (found.turns + crossing->turns) % 4);
    }
    if (isOnBorder || crossings == 0) tryFrom(start, 0);
    return best;
}

Foot FootSearch::walk(std::size_t surface, const LayoutPlace& start, const Eigen::Vector3d& point,
                      int& crossings) {
    Walk walk{surfaces_, crossings, start};
    walk.best.place = start;
    walk.best.distance = infinity;
    const auto extentOfStart = surfaces_.extent(start.patch);
    double wholeSteps = extentOfStart[0] + extentOfStart[1]; // that are left
    for (int k = 0; k < maxIterations;) {
        const PiecePoint here = evaluateAt(surface, walk.place);
        const Eigen::Vector3d away = point - here.position;
        const double distance = away.norm();
        const bool hasCrossed = walk.border.has_value() || walk.isOverLine;
        // What is as near beyond a border or line as on it may lead on.
        if (!(distance < (hasCrossed ? 1 + 1e-9 : 1) * walk.best.distance)) {
            if (!walk.goBack()) break;
            ++k;
            continue;
        }
        const bool hardly = !hasCrossed && distance > (1 - 1e-7) * walk.best.distance;
        walk.best = {walk.place, walk.turns, distance, here.position, here.du, here.dv};
        if (hardly) break;
        const auto extent = surfaces_.extent(walk.place.patch);
        const Step step = gaussNewton(here, away, walk.place.at, extent);
        if (!(step.isWhole && wholeSteps-- > 0)) ++k;
        if (!walk.goOn(step)) break;
    }
    return walk.best;
}

} // namespace qm
