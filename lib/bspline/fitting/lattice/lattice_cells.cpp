#include "bspline/fitting/lattice/lattice_cells.h"

#include "base/positions.h"

#include <algorithm>
#include <cmath>

namespace qm {

std::vector<KnotCell> cellsOf(const PatchSpace& space) {
    const auto& knots = space.knots;
    std::vector<KnotCell> cells;
    for (std::size_t a = 3; a + 4 < knots[0].size(); ++a)
        for (std::size_t b = 3; b + 4 < knots[1].size(); ++b) {
            const KnotCell cell{{knots[0][a], knots[1][b]}, {knots[0][a + 1], knots[1][b + 1]}};
            if (cell.length(0) > 0 && cell.length(1) > 0) cells.push_back(cell);
        }
    return cells;
}

LatticeRange rangeOf(const KnotCell& cell, const FitLattice& lattice) {
    LatticeRange range;
    for (std::size_t d = 0; d < 2; ++d) {
        const auto& parameters = lattice.targets.parameters[d];
        range.begin[d] = positionIn(parameters, std::ranges::lower_bound(parameters, cell.begin[d]));
        range.end[d] = positionIn(parameters, std::ranges::upper_bound(parameters, cell.end[d]));
    }
    return range;
}

WorstPoint worstIn(const KnotCell& cell, const FitLattice& lattice, const PatchErrors& errors) {
    WorstPoint worst;
    forPoints(cell, lattice, [&](std::size_t point) {
        if (errors.error[point] <= worst.error) return;
        worst = {errors.error[point], lattice.parametersAt(point), errors.isFolded[point]};
    });
    return worst;
}

bool isNear(const KnotCell& cell, const FitLattice& lattice, const PatchErrors& errors) {
    bool areNear = true;
    forPoints(cell, lattice, [&](std::size_t point) {
        if (std::abs(errors.signedDistance[point]) > 1) areNear = false;
    });
    return areNear;
}

std::array<double, 2> variation(const KnotCell& cell, const FitLattice& lattice, const PatchErrors& errors) {
    const LatticeRange range = rangeOf(cell, lattice);
    const auto at = [&](std::size_t i, std::size_t j) {
        return errors.signedDistance[j * lattice.columns() + i];
    };
    std::array<double, 2> result{};
    for (std::size_t j = range.begin[1]; j < range.end[1]; ++j)
        for (std::size_t i = range.begin[0]; i < range.end[0]; ++i) {
            if (i + 1 < range.end[0]) result[0] += std::abs(at(i + 1, j) - at(i, j));
            if (j + 1 < range.end[1]) result[1] += std::abs(at(i, j + 1) - at(i, j));
        }
    for (std::size_t d = 0; d < 2; ++d)
        result[d] /= static_cast<double>(range.end[1 - d] - range.begin[1 - d]);
    return result;
}

} // namespace qm
