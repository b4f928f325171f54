/// \file The cells into which knots divide a patch, and the points of its lattice in each cell.
#pragma once

#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/lattice_errors.h"
#include "bspline/splines/patch_space.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// A rectangle of parameters; entries are by direction, u and v.
struct KnotCell {
    std::array<double, 2> begin{};
    std::array<double, 2> end{};

    [[nodiscard]] double length(std::size_t direction) const { return end[direction] - begin[direction]; }
};

/// All rectangles between successive knots.
[[nodiscard]] std::vector<KnotCell> cellsOf(const PatchSpace& space);

/// The indices of the lattice points in a cell, its border included: from `begin` to before `end`.
struct LatticeRange {
    std::array<std::size_t, 2> begin{};
    std::array<std::size_t, 2> end{};
};

[[nodiscard]] LatticeRange rangeOf(const KnotCell& cell, const FitLattice& lattice);

/// Calls a function with the number of each of these points, row by row.
template <class Function>
void forPoints(const KnotCell& cell, const FitLattice& lattice, const Function& function) {
    const LatticeRange range = rangeOf(cell, lattice);
    for (std::size_t j = range.begin[1]; j < range.end[1]; ++j)
        for (std::size_t i = range.begin[0]; i < range.end[0]; ++i)
            function(j * lattice.columns() + i);
}

struct WorstPoint {
    double error = 0;
    std::array<double, 2> at{};
    bool isFolded = false;
};

[[nodiscard]] WorstPoint worstIn(const KnotCell& cell, const FitLattice& lattice, const PatchErrors& errors);

/// Whether all points of the cell are within the tolerance; folds do not count.
[[nodiscard]] bool isNear(const KnotCell& cell, const FitLattice& lattice, const PatchErrors& errors);

/// How much the errors vary along u and along v in a cell, averaged over the lattice lines: knots are missing
/// in the direction in which they vary.
[[nodiscard]] std::array<double, 2> variation(const KnotCell& cell, const FitLattice& lattice,
                                              const PatchErrors& errors);

} // namespace qm
