#include "bspline/fitting/given_up_cells.h"

#include <algorithm>
#include <cstddef>

namespace qm {
namespace {

template <class Function>
void forPoints(const KnotCell& cell, const FitLattice& lattice, const Function& function) {
    const LatticeRange range = rangeOf(cell, lattice);
    for (std::size_t j = range.begin[1]; j < range.end[1]; ++j)
        for (std::size_t i = range.begin[0]; i < range.end[0]; ++i)
            function(j * lattice.columns() + i);
}

} // namespace

void GivenUpCells::add(const KnotCell& cell, const LatticeSource& source, FitLattice& lattice,
                       PatchErrors& errors) {
    constexpr double slack = 1.1;
    places_.push_back({cell, slack * worstIn(cell, lattice, errors).error});
    forPoints(cell, lattice, [&](std::size_t k) { lattice.emphasis[k] = 1; });
    weighTargets(source, lattice);
    cap(places_.back(), lattice, errors);
}

void GivenUpCells::cap(const FitLattice& lattice, PatchErrors& errors) const {
    for (const Place& place : places_)
        cap(place, lattice, errors);
}

void GivenUpCells::cap(const Place& place, const FitLattice& lattice, PatchErrors& errors) {
    forPoints(place.cell, lattice, [&](std::size_t k) {
        double& error = errors.distance[k];
        error = error <= place.allowed ? std::min(error, 1.0) : error / place.allowed;
    });
}

} // namespace qm
