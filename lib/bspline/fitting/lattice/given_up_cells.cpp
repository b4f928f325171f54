#include "bspline/fitting/lattice/given_up_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace qm {

void GivenUpCells::add(const KnotCell& cell, FitLattice& lattice, PatchErrors& errors) {
    constexpr double slack = 1.1;
    Place place{cell, 1, false};
    forPoints(cell, lattice, [&](std::size_t k) {
        const double distance = std::abs(errors.signedDistance[k]);
        if (distance > 1) place.allowed = std::max(place.allowed, slack * distance);
        place.mayFold = place.mayFold || errors.isFolded[k];
        lattice.emphasis[k] = 1;
    });
    places_.push_back(place);
    cap(places_.back(), lattice, errors);
}

void GivenUpCells::cap(const FitLattice& lattice, PatchErrors& errors) const {
    for (const Place& place : places_)
        cap(place, lattice, errors);
}

void GivenUpCells::cap(const Place& place, const FitLattice& lattice, PatchErrors& errors) {
    forPoints(place.cell, lattice, [&](std::size_t k) {
        const double distance = std::abs(errors.signedDistance[k]);
        if (errors.isFolded[k] && !place.mayFold) return;
        errors.isFolded[k] = false;
        const double rest = distance <= place.allowed ? std::min(distance, 1.0) : distance / place.allowed;
        errors.error[k] = std::min(errors.error[k], rest);
    });
}

} // namespace qm
