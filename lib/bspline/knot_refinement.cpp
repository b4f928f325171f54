#include "bspline/knot_refinement.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace qm {

KnotRefinement::KnotRefinement(const std::vector<double>& knots, KnotRules rules) : rules_(std::move(rules)) {
    for (const double knot : knots) {
        if (places_.empty() || knot > places_.back()) {
            places_.push_back(knot);
            multiplicity_.push_back(0);
        }
        ++multiplicity_.back();
    }
    intervals_.resize(places_.size() - 1);
}

std::size_t KnotRefinement::intervalOf(double parameter) const {
    const auto after = std::upper_bound(places_.begin() + 1, places_.end() - 1, parameter);
    return static_cast<std::size_t>(after - places_.begin()) - 1;
}

bool KnotRefinement::canRaise(std::size_t place) const {
    return multiplicity_[place] < 3 && (rules_.everywhere || raisesFirst(place)) &&
           places_[place] == std::round(places_[place]);
}

/// Whether an edge of the shape has not yet got its knots.
bool KnotRefinement::raisesFirst(std::size_t place) const {
    const double at = places_[place];
    return multiplicity_[place] < 3 && at == std::round(at) &&
           static_cast<std::size_t>(at) < rules_.sharp.size() && rules_.sharp[static_cast<std::size_t>(at)];
}

bool KnotRefinement::canSplit(std::size_t interval) const {
    return places_[interval + 1] - places_[interval] > rules_.finest;
}

bool KnotRefinement::canRefine(double parameter) const {
    const std::size_t k = intervalOf(parameter);
    return canSplit(k) || canRaise(k) || canRaise(k + 1);
}

void KnotRefinement::addError(double parameter, double error) {
    Interval& interval = intervals_[intervalOf(parameter)];
    interval.weight += error * error;
    interval.moment += error * error * parameter;
}

void KnotRefinement::addKnot(double parameter) {
    asked_.push_back(parameter);
}

std::vector<double> KnotRefinement::refined() const {
    std::vector<int> raised = multiplicity_;
    std::vector<double> added;
    for (std::size_t k = 0; k < intervals_.size(); ++k) {
        if (!(intervals_[k].weight > 0)) continue;
        if (places_[k + 1] - places_[k] > 1) {
            const double centre = std::round(intervals_[k].moment / intervals_[k].weight);
            const double first = std::floor(places_[k]) + 1;
            const double last = std::ceil(places_[k + 1]) - 1;
            added.push_back(std::clamp(centre, first, last));
            continue;
        }
        if (canSplit(k) && !raisesFirst(k) && !raisesFirst(k + 1)) {
            added.push_back((places_[k] + places_[k + 1]) / 2);
            continue;
        }
        for (const std::size_t end : {k, k + 1})
            if (canRaise(end)) raised[end] = multiplicity_[end] + 1;
    }
    for (const double parameter : asked_) {
        const auto place = std::lower_bound(places_.begin(), places_.end(), parameter);
        const auto k = static_cast<std::size_t>(place - places_.begin());
        if (*place != parameter)
            added.push_back(parameter);
        else if (canRaise(k))
            raised[k] = multiplicity_[k] + 1;
    }
    std::sort(added.begin(), added.end());
    added.erase(std::unique(added.begin(), added.end()), added.end());
    for (std::size_t k = 0; k < places_.size(); ++k)
        added.insert(added.end(), static_cast<std::size_t>(raised[k]), places_[k]);
    std::sort(added.begin(), added.end());
    return added;
}

std::vector<double> KnotRefinement::enriched() const {
    auto more = refined();
    const auto order = static_cast<std::size_t>(multiplicity_.front());
    if (order == 4 || more.size() == 2 * order) return more;
    std::vector<double> raised(order + 1, places_.front());
    raised.insert(raised.end(), order + 1, places_.back());
    return raised;
}

std::vector<double> bareKnots(double length) {
    return {0, 0, 0, 0, length, length, length, length};
}

} // namespace qm
