/// \file The cells of a patch in which neither knots nor weights reduce the error any further.
#pragma once

#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/lattice_cells.h"
#include "bspline/fitting/lattice/lattice_errors.h"

#include <vector>

namespace qm {

/// Errors in these cells no longer count as missed, unless they grow. Where a cell is folded, only the fold
/// is given up, not the distance.
class GivenUpCells {
public:
    /// Gives up a cell with its present distance plus a tenth, and resets the emphasis of its points.
    void add(const KnotCell& cell, FitLattice& lattice, PatchErrors& errors);

    /// Lowers the errors of these cells to 1, or to the factor by which they have grown.
    void cap(const FitLattice& lattice, PatchErrors& errors) const;

private:
    struct Place {
        KnotCell cell;
        double allowed = 1; ///< the distance that is given up, in tolerances
        bool mayFold = false;
    };

    static void cap(const Place& place, const FitLattice& lattice, PatchErrors& errors);

    std::vector<Place> places_;
};

} // namespace qm
