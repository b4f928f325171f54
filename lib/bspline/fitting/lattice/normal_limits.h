/// \file How far the normals of a fit may deviate from those of the reference (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/reference/lattice/reference_grid.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Limits of the slope that may be lost by leaving out a knot, for the grid of one segment. Where the normal
/// turns evenly from one mesh edge to the next, as on spheres and cylinders, a surface must follow it
/// closely, because reflections show waves that are far smaller than any tolerance. Where it turns unevenly,
/// because of noise or of too few edges, the reference itself does not know it better.
class NormalLimits {
public:
    explicit NormalLimits(const ReferenceGrid& grid);

    /// The largest angle in radians by which a line along u (0) or v (1) may deviate at some parameters.
    [[nodiscard]] double at(std::size_t direction, const std::array<double, 2>& parameters) const;

private:
    std::size_t columns_;
    std::array<std::vector<double>, 2> limits_; ///< by direction and vertex
};

} // namespace qm
