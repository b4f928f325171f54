/// \file Where to put more knots: gathers errors by knot interval, then refines the intervals that have some.
#pragma once

#include <cstddef>
#include <vector>

namespace qm {

/// As fine as knots get where the shape is smooth; finer ones would follow the mesh's facets, and wave unseen
/// between the samples of a fit.
constexpr double finestKnots = 0.5;

/// Where knots may go besides integers.
struct KnotRules {
    double finest = 1;      ///< intervals of length one are halved down to this
    bool everywhere = true; ///< continuity may be taken from any integer, at last
    std::vector<bool>
        sharp; ///< by integer: the shape itself has an edge there, which costs continuity at once
};

/// Works on clamped cubic knots. An interval is split at the integer nearest to its errors' centre of
/// gravity, or in the middle if there is none inside; one that is short enough gets more continuity taken
/// from its ends: there are up to three knots at one place, and with three at every integer any polyline is
/// in the space.
class KnotRefinement {
public:
    KnotRefinement(const std::vector<double>& knots, KnotRules rules);

    /// False if nothing can be gained at this parameter any more.
    [[nodiscard]] bool canRefine(double parameter) const;
    void addError(double parameter, double error);
    /// Asks for a knot at an inner integer, or for one more.
    void addKnot(double parameter);
    /// The knots with all that was asked for.
    [[nodiscard]] std::vector<double> refined() const;
    /// The same for knots of degree one or two without any inside: there the degree rises first.
    [[nodiscard]] std::vector<double> enriched() const;

private:
    struct Interval {
        double weight = 0;
        double moment = 0;
    };
    [[nodiscard]] std::size_t intervalOf(double parameter) const;
    [[nodiscard]] bool canRaise(std::size_t place) const;
    [[nodiscard]] bool raisesFirst(std::size_t place) const;
    [[nodiscard]] bool canSplit(std::size_t interval) const;

    KnotRules rules_;
    std::vector<double> places_;    ///< the different knots
    std::vector<int> multiplicity_; ///< of each
    std::vector<Interval> intervals_;
    std::vector<double> asked_;
};

/// Clamped cubic knots over [0, length] without any inside.
[[nodiscard]] std::vector<double> bareKnots(double length);

} // namespace qm
