/// \file How far the normals of a fit may deviate from those of the reference (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/reference/lattice/reference_grid.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Limits of the slope that may be lost by leaving out a knot, for the grid of one segment. Where the normal
/// turns evenly from one mesh edge to the next, as on spheres and cylinders, a surface must follow it
/// closely, because reflections show waves that are far smaller than any tolerance. Where it turns unevenly,
/// because of noise or of too few edges, the reference itself does not know it better. The same holds for the
/// directions of creases: the surfaces beside them turn with them.
class NormalLimits {
public:
    explicit NormalLimits(const ReferenceGrid& grid);

    /// The largest angle in radians by which a line along u (0) or v (1) may deviate at some parameters.
    [[nodiscard]] double at(std::size_t direction, const std::array<double, 2>& parameters) const;
    /// The same where the line is a crease.
    [[nodiscard]] double onCrease(std::size_t direction, const std::array<double, 2>& parameters) const;
    /// The limit of a line of a lattice at its point k; infinite at corners, and where it ends at a crease.
    [[nodiscard]] double at(const FitLattice& lattice, std::size_t direction, std::size_t line,
                            std::size_t k) const;

private:
    /// Limits by direction and vertex.
    using Limits = std::array<std::vector<double>, 2>;

    [[nodiscard]] std::size_t vertexAt(const std::array<double, 2>& parameters) const;

    std::array<std::size_t, 2> size_; ///< quads along u and v
    Limits ofNormals_;
    Limits ofCreases_;
};

} // namespace qm
