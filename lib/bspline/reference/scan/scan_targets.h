/// \file The targets on a scan while they are determined: stored by lattice point, accessed by grid
/// (docs/METHOD.md#reference).
#pragma once

#include "base/at.h"
#include "bspline/reference/lattice/fit_target.h"
#include "bspline/reference/lattice/lattice_normals.h"
#include "bspline/reference/scan/scan_projection.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

struct ScanTargets {
    /// Gives every displacement a weight of 1, and takes the scan for fine.
    /// \param lattice  of `surface`; both must outlive this
    ScanTargets(const LatticeNormals& lattice, const std::vector<ReferenceGrid>& surface,
                std::vector<Displacement> displacements);

    const LatticeNormals& lattice;
    const std::vector<ReferenceGrid>& surface;
    std::vector<Displacement> displacements; ///< present wherever the weight is above 0
    std::vector<double> weights;             ///< from 0 to 1
    double noise = 0;                        ///< standard deviation of the offsets
    double grain = 0;                        ///< length of a triangle's edges, in lattice steps

    [[nodiscard]] int columns(std::size_t g) const { return surface[g].size[0] * surface[g].steps; }
    [[nodiscard]] int rows(std::size_t g) const { return surface[g].size[1] * surface[g].steps; }
    [[nodiscard]] std::size_t index(std::size_t g, int i, int j) const {
        return at(j) * at(columns(g) + 1) + at(i);
    }

    /// So far apart offsets have noise of their own: nearer ones come from one triangle, or share a vertex.
    [[nodiscard]] int stepsOfGrain() const;

    template <class Function> void forEachPoint(const Function& f) const {
        for (std::size_t g = 0; g < surface.size(); ++g)
            for (int j = 0; j <= rows(g); ++j)
                for (int i = 0; i <= columns(g); ++i)
                    f(g, i, j, lattice.numbers[g][index(g, i, j)]);
    }

    /// The lattice point that a point of a grid is; none outside the grid.
    [[nodiscard]] std::optional<std::size_t> numberAt(std::size_t g, int i, int j) const;
    /// The height of the scan above a point of a grid; none outside the grid, without a target, and at sharp
    /// points.
    [[nodiscard]] std::optional<double> offset(std::size_t g, int i, int j) const;
    /// The share of the smooth points for which the scan shows a point.
    [[nodiscard]] double coverage() const;
    /// Grids, weights and noise.
    [[nodiscard]] FitTarget result() const;
    /// Takes over the changes that were made to the result.
    void update(const FitTarget& result);
};

} // namespace qm
