#include "bspline/fitting/knots/knot_plan.h"

#include "base/at.h"
#include "layout/sides.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace qm {
namespace {

/// \return false if the list has the knot already
bool insertSorted(std::vector<double>& list, double knot) {
    const auto place = std::ranges::lower_bound(list, knot);
    if (place != list.end() && *place == knot) return false;
    list.insert(place, knot);
    return true;
}

/// Whether each edge of each side of each patch is smooth, in the direction of the parameters.
using SmoothFlags = std::vector<std::array<std::vector<bool>, 4>>;

SmoothFlags smoothSides(const std::vector<std::array<int, 2>>& sizes, const SmoothNetwork& network) {
    SmoothFlags flags(sizes.size());
    for (std::size_t patch = 0; patch < sizes.size(); ++patch)
        for (int side = 0; side < 4; ++side)
            flags[patch][at(side)].resize(at(sizes[patch][directionAlong(side)]));
    for (const SmoothRun& run : network.runs)
        for (const StretchSide& place : network.stretches[run.stretch].sides)
            for (int x = run.begin; x < run.end; ++x) {
                const double middle = patchParameter(sizes[place.patch], place, x + 0.5);
                flags[place.patch][at(place.side)][static_cast<std::size_t>(middle)] = true;
            }
    return flags;
}

KnotLists findTurns(const std::vector<std::array<int, 2>>& sizes, const SmoothNetwork& network) {
    const SmoothFlags flags = smoothSides(sizes, network);
    KnotLists turns(sizes.size());
    for (std::size_t patch = 0; patch < sizes.size(); ++patch)
        for (int side = 0; side < 4; ++side) {
            const auto& smooth = flags[patch][at(side)];
            for (std::size_t k = 1; k < smooth.size(); ++k)
                if (smooth[k] != smooth[k - 1])
                    insertSorted(turns[patch][directionAlong(side)], static_cast<double>(k));
        }
    return turns;
}

/// Half a length, rounded down to whole edges above one edge: knots at grid lines are cheaper, because
/// neighbours have them as well.
double half(double length) {
    return length > 1 ? std::floor(length / 2) : length / 2;
}

/// Makes a linear ratio quadratic, with both of its ends at half of its run.
void endAtHalf(TangentRatio& ratio) {
    ratio.isLinear = false;
    ratio.reach.fill(half(ratio.length));
}

/// The mean length of a grid's edges along u (0) or v (1).
double meanEdge(const ReferenceGrid& grid, std::size_t direction) {
    const std::array<std::size_t, 2> lines{grid.columns(), grid.rows()};
    const std::size_t stride = direction == 0 ? 1 : lines[0];
    double sum = 0;
    for (std::size_t k = 0; k + stride < grid.points.size(); ++k)
        if (direction == 1 || k % lines[0] + 1 < lines[0])
            sum += (grid.points[k + stride] - grid.points[k]).norm();
    return sum / static_cast<double>(lines[1 - direction]) / grid.size[direction];
}

} // namespace

IntervalLengths partsOfEdges(const std::vector<ReferenceGrid>& grids, double length) {
    IntervalLengths parts;
    for (const ReferenceGrid& grid : grids) {
        std::array<double, 2>& ofPatch = parts.emplace_back();
        for (std::size_t d = 0; d < 2; ++d) {
            const double edge = meanEdge(grid, d);
            ofPatch[d] = edge > 0 ? length / edge : 0;
        }
    }
    return parts;
}

KnotPlan::KnotPlan(const Layout& layout, const SmoothNetwork& network, IntervalLengths shortest,
                   const KnotLists& twice)
    : stretches_(&network.stretches), runs_(network.runs), chosen_(layout.segments.size()),
      shortest_(std::move(shortest)) {
    shortest_.resize(layout.segments.size());
    for (const Segment& segment : layout.segments)
        sizes_.push_back(segment.size);
    alwaysDouble_ = findTurns(sizes_, network);
    for (std::size_t patch = 0; patch < twice.size(); ++patch)
        for (const std::size_t direction : {0U, 1U})
            for (const double knot : twice[patch][direction])
                insertSorted(alwaysDouble_[patch][direction], knot);
    for (SmoothRun& run : runs_) {
        TangentRatio& ratio = run.ratio;
        ratio.isLinear = ratio.atEnd[0] != 0 && ratio.atEnd[1] != 0;
        for (std::size_t end = 0; end < 2; ++end)
            ratio.reach[end] = ratio.atEnd[end] == 0 ? 0 : ratio.length;
    }
}

double KnotPlan::minInterval(std::size_t patch, std::size_t direction) const {
    const double shortest = shortest_[patch][direction];
    switch (minInterval_) {
    case MinInterval::quarter:
        return std::max(0.25, 2 * shortest);
    case MinInterval::eighth:
        return std::max(0.125, shortest);
    case MinInterval::thirtySecond:
        break;
    }
    return std::max(0.03125, shortest);
}

bool KnotPlan::allow(MinInterval length) {
    if (length <= minInterval_) return false;
    minInterval_ = length;
    return true;
}

bool KnotPlan::insert(std::size_t patch, std::size_t direction, double knot) {
    const bool isInside = knot > 0 && knot < sizes_[patch][direction];
    return isInside && insertSorted(chosen_[patch][direction], knot);
}

void KnotPlan::erase(std::size_t patch, std::size_t direction, double knot) {
    std::erase(chosen_[patch][direction], knot);
}

double KnotPlan::firstKnot(const RunEnd& end) const {
    const SmoothRun& run = runs_[end.run];
    double reach = run.ratio.length;
    for (const StretchSide& place : stretches()[run.stretch].sides)
        for (const double knot : chosen_[place.patch][directionAlong(place.side)]) {
            const double x = stretchParameter(sizes_[place.patch], place, knot);
            if (x > run.begin && x < run.end) reach = std::min(reach, run.distanceFrom(end.end, x));
        }
    return reach;
}

void KnotPlan::endAtFirstKnots() {
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        TangentRatio& ratio = runs_[run].ratio;
        for (std::size_t end = 0; end < 2; ++end)
            if (ratio.atEnd[end] != 0) ratio.reach[end] = firstKnot({run, end});
        if (!ratio.isLinear || (ratio.reach[0] == ratio.length && ratio.reach[1] == ratio.length)) continue;
        ratio.isLinear = false;
        for (double& reach : ratio.reach)
            reach = std::min(reach, half(ratio.length));
    }
}

void KnotPlan::limitReach(const RunEnd& end, double max) {
    TangentRatio& ratio = runs_[end.run].ratio;
    if (ratio.isLinear) endAtHalf(ratio);
    ratio.reach[end.end] = std::min(ratio.reach[end.end], max);
}

bool KnotPlan::shorten(const RunEnd& end) {
    TangentRatio& ratio = runs_[end.run].ratio;
    if (ratio.atEnd[end.end] == 0) return false;
    if (ratio.isLinear) {
        endAtHalf(ratio);
        return true;
    }
    double& reach = ratio.reach[end.end];
    for (const StretchSide& place : stretches()[runs_[end.run].stretch].sides)
        if (reach / 2 < minInterval(place.patch, directionAlong(place.side))) return false;
    reach = half(reach);
    return true;
}

std::vector<PatchKnot> KnotPlan::knotsAt(const RunEnd& end, double reach) const {
    const SmoothRun& run = runs_[end.run];
    std::vector<PatchKnot> knots;
    for (const StretchSide& place : stretches()[run.stretch].sides) {
        const auto& size = sizes_[place.patch];
        const std::size_t direction = directionAlong(place.side);
        const double knot = patchParameter(size, place, run.parameterAt(end.end, reach));
        if (knot > 0 && knot < size[direction]) knots.push_back({place.patch, direction, knot});
    }
    return knots;
}

KnotLists KnotPlan::doubleKnots() const {
    KnotLists knots = alwaysDouble_;
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        const TangentRatio& ratio = runs_[run].ratio;
        for (std::size_t end = 0; end < 2; ++end) {
            if (ratio.isLinear || ratio.atEnd[end] == 0) continue;
            for (const auto& [patch, direction, knot] : knotsAt({run, end}, ratio.reach[end]))
                insertSorted(knots[patch][direction], knot);
        }
    }
    return knots;
}

std::vector<PatchSpace> KnotPlan::spaces() const {
    const KnotLists doubles = doubleKnots();
    std::vector<PatchSpace> spaces(sizes_.size());
    std::size_t unknowns = 0;
    for (std::size_t patch = 0; patch < sizes_.size(); ++patch) {
        for (std::size_t direction = 0; direction < 2; ++direction) {
            std::vector<double> twice;
            for (const double knot : doubles[patch][direction])
                twice.insert(twice.end(), 2, knot);
            auto& knots = spaces[patch].knots[direction];
            knots.assign(4, 0);
            std::ranges::set_union(chosen_[patch][direction], twice, std::back_inserter(knots));
            knots.insert(knots.end(), 4, sizes_[patch][direction]);
        }
        spaces[patch].firstUnknown = unknowns;
        unknowns += spaces[patch].size();
    }
    return spaces;
}

} // namespace qm
