/// \file Where to put more knots: gathers errors by knot interval, then refines the intervals that have some.
#pragma once

#include <cstddef>
#include <vector>

namespace qm {

/// Works on clamped cubic knots at integers. An interval is split at the integer nearest to its errors'
/// centre of gravity; one of length one gets more continuity taken from its ends: there are up to three knots
/// at one place, and with three everywhere any polyline is in the space.
class KnotRefinement {
public:
    explicit KnotRefinement(std::vector<double> knots);

    /// False if nothing can be gained at this parameter any more.
    [[nodiscard]] bool canRefine(double parameter) const;
    void addError(double parameter, double error);
    /// Asks for a knot at an inner integer, or for one more.
    void addKnot(double parameter);
    /// The knots with all that was asked for.
    [[nodiscard]] std::vector<double> refined() const;

    [[nodiscard]] bool hasRepeatedKnots() const;

private:
    struct Interval {
        double weight = 0;
        double moment = 0;
    };
    [[nodiscard]] std::size_t intervalOf(double parameter) const;
    [[nodiscard]] bool canRaise(std::size_t place) const;

    std::vector<double> places_;    ///< the different knots
    std::vector<int> multiplicity_; ///< of each
    std::vector<Interval> intervals_;
    std::vector<double> asked_;
};

/// Clamped cubic knots over [0, length] without any inside.
[[nodiscard]] std::vector<double> bareKnots(double length);

} // namespace qm
