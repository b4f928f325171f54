/// \file By how much the normals of a fit may be off those of the reference (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/reference/reference_grid.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Slopes that knots may leave out, in the grid of one segment. Where the normal turns evenly from one mesh
/// edge to the next, as on spheres and cylinders, a surface has to follow it closely: reflections show waves
/// that are far smaller than any tolerance. Where it turns unevenly, because of noise or of too few edges,
/// the reference knows it no better than that.
class NormalLimits {
public:
    explicit NormalLimits(const ReferenceGrid& grid);

    /// Largest angle, radians, that a line along u (0) or v (1) may be off at some parameters.
    [[nodiscard]] double at(std::size_t direction, const std::array<double, 2>& parameters) const;

private:
    std::size_t columns_;
    std::array<std::vector<double>, 2> limits_; ///< by direction, by vertex
};

} // namespace qm
