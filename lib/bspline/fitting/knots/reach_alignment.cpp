#include "bspline/fitting/knots/reach_alignment.h"

#include "layout/sides.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace qm {
namespace {

/// How far an end may move, relative to its first reach, and how near to its vertex, in mesh edges. Within a
/// longer reach a border is a single quadratic, and seldom near enough.
struct Movement {
    static constexpr double nearest = 0.25;
    static constexpr double farthest = 2;
    static constexpr double minReach = 0.25;
};

/// Every move can make others worth while.
constexpr int maxPasses = 4;

/// The end of a tangent ratio.
struct RatioEnd : RunEnd {
    double firstReach = 0;
    bool isShortened = false; ///< since then, for an even vertex
};

class Alignment {
public:
    /// \param first  the runs before reaches were shortened for even vertices
    Alignment(const std::vector<SmoothRun>& first, const std::vector<EvenVertex>& vertices, double allowed,
              KnotPlan& plan)
        : plan_(plan), vertices_(vertices), allowed_(allowed), spaces_(plan.spaces()),
          users_(spaces_.size()) {
        for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex)
            for (std::size_t border = 0; border < vertices[vertex].borders.size(); ++border)
                evenPlaces_[vertices[vertex].borders[border].end] = {vertex, border};
        for (std::size_t patch = 0; patch < spaces_.size(); ++patch)
            for (const std::size_t direction : {0U, 1U})
                for (const double knot : plan.alwaysDouble()[patch][direction])
                    ++users_[patch][direction][knot];
        for (std::size_t run = 0; run < plan.runs().size(); ++run) {
            const TangentRatio& ratio = plan.runs()[run].ratio;
            for (const std::size_t end : {0U, 1U}) {
                if (ratio.isLinear || ratio.atEnd[end] == 0) continue;
                const TangentRatio& before = first[run].ratio;
                const double firstReach = before.isLinear ? ratio.length / 2 : before.reach[end];
                ends_.push_back({{run, end}, firstReach, ratio.reach[end] < firstReach});
                use(ends_.back(), ratio.reach[end], 1);
            }
        }
    }

    void run() {
        for (int pass = 0; pass < maxPasses; ++pass) {
            bool hasMoved = false;
            for (const RatioEnd& end : ends_)
                hasMoved = move(end) || hasMoved;
            if (!hasMoved) return;
        }
    }

private:
    /// A border of an even vertex.
    struct EvenPlace {
        std::size_t vertex = 0;
        std::size_t border = 0;
    };

    [[nodiscard]] const SmoothRun& runOf(const RatioEnd& end) const { return plan_.runs()[end.run]; }
    [[nodiscard]] double reach(const RatioEnd& end) const { return runOf(end).ratio.reach[end.end]; }

    void use(const RatioEnd& end, double reach, int count) {
        for (const auto& [patch, direction, knot] : plan_.knotsAt(end, reach))
            users_[patch][direction][knot] += count;
    }

    /// The control points that a reach takes in addition to what others need.
    [[nodiscard]] std::size_t cost(const RatioEnd& end, double reach) const {
        std::size_t points = 0;
        for (const auto& [patch, direction, knot] : plan_.knotsAt(end, reach)) {
            const auto& users = users_[patch][direction];
            if (const auto found = users.find(knot); found != users.end() && found->second > 0) continue;
            const std::size_t times =
                std::ranges::binary_search(plan_.chosen(patch, direction), knot) ? 1 : 2;
            points += times * spaces_[patch].count(1 - direction);
        }
        return points;
    }

    /// The reaches with which this end would be where others end, and the first one if it is shorter now.
    [[nodiscard]] std::vector<double> candidates(const RatioEnd& end) const {
        const SmoothRun& run = runOf(end);
        const double farthest =
            std::min(Movement::farthest * end.firstReach, run.ratio.length - run.ratio.reach[1 - end.end]);
        const double nearest = std::max(Movement::nearest * end.firstReach, Movement::minReach);
        std::vector<double> reaches;
        if (end.isShortened && end.firstReach <= farthest) reaches.push_back(end.firstReach);
        if (nearest > farthest) return reaches;
        for (const StretchSide& side : plan_.stretches()[run.stretch].sides) {
            const auto& size = plan_.sizes()[side.patch];
            const auto knotAt = [&](double reach) {
                return patchParameter(size, side, run.parameterAt(end.end, reach));
            };
            const auto& users = users_[side.patch][directionAlong(side.side)];
            const auto [first, last] = std::minmax({knotAt(nearest), knotAt(farthest)});
            for (auto place = users.lower_bound(first); place != users.end() && place->first <= last; ++place)
                if (place->second > 0)
                    reaches.push_back(run.distanceFrom(end.end, stretchParameter(size, side, place->first)));
        }
        return reaches;
    }

    /// False if the borders of an even vertex could not be near enough to the reference.
    [[nodiscard]] bool isAllowed(const RatioEnd& end, double reach) const {
        const auto found = evenPlaces_.find(end);
        if (found == evenPlaces_.end()) return true;
        const EvenVertex& vertex = vertices_[found->second.vertex];
        std::vector<double> reaches = reachesAt(vertex, plan_);
        const double before = minError(vertex, reaches);
        reaches[found->second.border] = reach;
        return minError(vertex, reaches) <= std::max(allowed_, before);
    }

    /// \return false if the end is best where it is
    bool move(const RatioEnd& end) {
        use(end, reach(end), -1);
        double best = reach(end);
        std::size_t min = cost(end, best);
        for (const double candidate : candidates(end)) {
            const std::size_t points = cost(end, candidate);
            if (points >= min || !isAllowed(end, candidate)) continue;
            best = candidate;
            min = points;
        }
        const bool moves = best != reach(end);
        plan_.setReach(end, best);
        use(end, best, 1);
        return moves;
    }

    KnotPlan& plan_;
    const std::vector<EvenVertex>& vertices_;
    double allowed_;
    std::map<RunEnd, EvenPlace> evenPlaces_;
    std::vector<PatchSpace> spaces_; ///< before
    /// By patch, direction and knot: how many reasons there are for it to be double.
    std::vector<std::array<std::map<double, int>, 2>> users_;
    std::vector<RatioEnd> ends_;
};

} // namespace

void alignReaches(KnotPlan& plan, const std::vector<EvenVertex>& vertices, double allowed) {
    const std::vector<SmoothRun> first = plan.runs();
    shortenAtEvenVertices(vertices, allowed, plan);
    Alignment(first, vertices, allowed, plan).run();
}

} // namespace qm
