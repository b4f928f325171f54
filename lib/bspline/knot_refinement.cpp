#include "bspline/knot_refinement.h"

#include <algorithm>
#include <cmath>

namespace qm {

KnotRefinement::KnotRefinement(std::vector<double> knots) {
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
    return multiplicity_[place] < 3;
}

bool KnotRefinement::canRefine(double parameter) const {
    const std::size_t k = intervalOf(parameter);
    return places_[k + 1] - places_[k] > 1 || canRaise(k) || canRaise(k + 1);
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
            added.push_back(std::clamp(centre, places_[k] + 1, places_[k + 1] - 1));
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

bool KnotRefinement::hasRepeatedKnots() const {
    return std::any_of(multiplicity_.begin() + 1, multiplicity_.end() - 1, [](int m) { return m > 1; });
}

std::vector<double> bareKnots(double length) {
    return {0, 0, 0, 0, length, length, length, length};
}

} // namespace qm
