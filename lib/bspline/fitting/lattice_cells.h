/// \file The cells that knots divide a patch into, and the points of its lattice over them.
#pragma once

#include "bspline/fitting/fit_lattice.h"
#include "bspline/fitting/lattice_errors.h"
#include "bspline/network/border_strip.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// A rectangle of parameters, by direction.
struct KnotCell {
    std::array<double, 2> begin{};
    std::array<double, 2> end{};

    [[nodiscard]] double length(std::size_t direction) const { return end[direction] - begin[direction]; }
};

/// All rectangles between knots that follow one another.
[[nodiscard]] std::vector<KnotCell> cellsOf(const PatchSpace& space);

/// The points of a lattice over a cell, those on its border included: from `begin` to before `end`.
struct LatticeRange {
    std::array<std::size_t, 2> begin{};
    std::array<std::size_t, 2> end{};
};

[[nodiscard]] LatticeRange rangeOf(const KnotCell& cell, const FitLattice& lattice);

struct WorstPoint {
    double error = 0;
    std::array<double, 2> at{};
    bool isFolded = false;
};

[[nodiscard]] WorstPoint worstIn(const KnotCell& cell, const FitLattice& lattice, const PatchErrors& errors);

/// Whether all distances there are within the tolerance.
[[nodiscard]] bool isNear(const KnotCell& cell, const FitLattice& lattice, const PatchErrors& errors);

/// How much the errors vary along each direction of a cell, in the mean over its lines: knots are missing in
/// the direction in which they do.
[[nodiscard]] std::array<double, 2> variation(const KnotCell& cell, const FitLattice& lattice,
                                              const PatchErrors& errors);

} // namespace qm
