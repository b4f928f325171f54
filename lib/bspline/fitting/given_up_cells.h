/// \file The cells of a patch in which nothing helps.
#pragma once

#include "bspline/fitting/fit_lattice.h"
#include "bspline/fitting/lattice_cells.h"
#include "bspline/fitting/lattice_errors.h"

#include <vector>

namespace qm {

/// Errors in these cells are not missed, unless they grow. Where a cell is folded only that is given up, and
/// not the distance.
class GivenUpCells {
public:
    /// Gives up a cell, with the error that it has and a little more; its points weigh what others do.
    void add(const KnotCell& cell, const LatticeSource& source, FitLattice& lattice, PatchErrors& errors);

    /// Lowers the errors that are given up to 1, or to what they have grown by.
    void cap(const FitLattice& lattice, PatchErrors& errors) const;

private:
    struct Place {
        KnotCell cell;
        double allowed = 1; ///< distance
        bool mayFold = false;
    };

    static void cap(const Place& place, const FitLattice& lattice, PatchErrors& errors);

    std::vector<Place> places_;
};

} // namespace qm
