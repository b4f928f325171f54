#include "bspline/fitting/knots/initial_knots.h"

#include "bspline/fitting/lattice/lattice_lines.h"
#include "layout/sides.h"

#include <algorithm>

namespace qm {

std::vector<double> knotsBeside(const StretchMap& map, const KnotPlan& plan, std::size_t patch,
                                std::size_t direction) {
    std::vector<double> knots;
    for (const bool isFar : {false, true})
        for (const StretchEnd& end : map.on(patch, sideAcross(1 - direction, isFar))) {
            const Stretch& stretch = plan.stretches()[end.stretch];
            const StretchSide& other = stretch.sides[1 - end.which];
            for (const double knot : plan.chosen(other.patch, directionAlong(other.side))) {
                const double x = stretchParameter(plan.sizes()[other.patch], other, knot);
                if (x > 0 && x < stretch.length())
                    knots.push_back(patchParameter(plan.sizes()[patch], stretch.sides[end.which], x));
            }
        }
    std::ranges::sort(knots);
    return knots;
}

void insertInitialKnots(const std::vector<FitLattice>& lattices, const std::vector<NormalLimits>& limits,
                        const StretchMap& map, const std::vector<double>& tolerances, KnotPlan& plan) {
    for (std::size_t patch = 0; patch < lattices.size(); ++patch)
        for (std::size_t direction = 0; direction < 2; ++direction) {
            LatticeLines lines(lattices[patch], limits[patch], direction, tolerances[patch]);
            const auto fit = [&](int begin, int end) { return lines.fit(begin, end); };
            const auto beside = knotsBeside(map, plan, patch, direction);
            int begin = 0;
            while (begin < lines.length()) {
                int end = farthestReach(begin, lines.length(), fit);
                const double min = std::max(begin + notMuchNearer * (end - begin), begin + 1.0);
                const auto after = std::ranges::upper_bound(beside, static_cast<double>(end));
                if (end < lines.length() && after != beside.begin() && *(after - 1) >= min)
                    end = static_cast<int>(*(after - 1));
                plan.insert(patch, direction, end);
                begin = end;
            }
        }
}

} // namespace qm
