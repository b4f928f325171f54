#include "bspline/fitting/knots/border_knots.h"

#include "bspline/fitting/knots/initial_knots.h"
#include "bspline/fitting/lattice/lattice_lines.h"
#include "layout/sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace qm {
namespace {

/// The knots of one stretch.
class StretchKnots {
public:
    StretchKnots(const Stretch& stretch, KnotPlan& plan) : stretch_(stretch), plan_(plan) {}

    /// The last grid line from `begin` to `end`, both included, that is a knot of all given sides.
    /// \return 0 if there is none
    [[nodiscard]] int last(int begin, int end, std::span<const std::size_t> sides) const {
        for (int x = end; x >= begin; --x)
            if (std::ranges::all_of(sides, [&](std::size_t side) { return isKnot(x, side); })) return x;
        return 0;
    }

    void insert(int x) {
        for (const StretchSide& place : stretch_.sides)
            plan_.insert(place.patch, directionAlong(place.side), parameter(x, place));
    }

private:
    [[nodiscard]] double parameter(int x, const StretchSide& place) const {
        return patchParameter(plan_.sizes()[place.patch], place, x);
    }
    [[nodiscard]] bool isKnot(int x, std::size_t side) const {
        const StretchSide& place = stretch_.sides[side];
        return std::ranges::binary_search(plan_.chosen(place.patch, directionAlong(place.side)),
                                          parameter(x, place));
    }

    const Stretch& stretch_;
    KnotPlan& plan_;
};

/// The knot that ends the interval from `begin`, if a cubic reaches to `farthest`: one that both sides have,
/// or else one that one of them has, unless it is much nearer than `farthest`.
int nextKnot(const StretchKnots& knots, int begin, int farthest) {
    const int min = begin + std::max(1, static_cast<int>(std::ceil(notMuchNearer * (farthest - begin))));
    static constexpr std::array<std::size_t, 2> sides{0, 1};
    const std::span all(sides);
    if (const int x = knots.last(min, farthest, all); x != 0) return x;
    const int x = std::max(knots.last(min, farthest, all.first(1)), knots.last(min, farthest, all.last(1)));
    return x != 0 ? x : farthest;
}

} // namespace

void insertBorderKnots(const std::vector<FitLattice>& lattices, const std::vector<NormalLimits>& limits,
                       const std::vector<double>& tolerances, KnotPlan& plan) {
    for (const Stretch& stretch : plan.stretches()) {
        const StretchSide& place = stretch.sides[0];
        const auto& size = plan.sizes()[place.patch];
        const double tolerance = std::min(tolerances[place.patch], tolerances[stretch.sides[1].patch]);
        LatticeLines lines(lattices[place.patch], limits[place.patch], directionAlong(place.side), tolerance);
        const std::size_t line = isFarSide(place.side) ? lines.count() - 1 : 0; // along the side
        const auto fits = [&](int begin, int end) {
            const auto a = static_cast<int>(patchParameter(size, place, begin));
            const auto b = static_cast<int>(patchParameter(size, place, end));
            return lines.fits(line, std::min(a, b), std::max(a, b));
        };
        StretchKnots knots(stretch, plan);
        for (int begin = 0; begin < stretch.length();) {
            const int farthest = farthestReach(begin, stretch.length(), fits);
            if (farthest == stretch.length()) break;
            begin = nextKnot(knots, begin, farthest);
            knots.insert(begin);
        }
    }
}

} // namespace qm
