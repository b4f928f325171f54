/// \file Is a surface as smooth as its reference? Normals and curvatures beside one another.
#pragma once

#include "bspline/measure/paired_surfaces.h"

#include <array>
#include <cstddef>

namespace qm {

struct ShapeMeasures {
    double largestNormalDeviation = 0; ///< degrees
    /// Squared angle between the normals, square degrees, summed over the parameters' area.
    double squaredNormalDeviation = 0;
    double area = 0; ///< of the parameters
    /// The sum of the squares of both principal curvatures over the surface, and over the reference; without
    /// unit.
    std::array<double, 2> bending{};

    void add(const ShapeMeasures& other);
    [[nodiscard]] double rmsNormalDeviation() const;
    /// How many times the reference's bending the surface has; 1 if both are plane.
    [[nodiscard]] double bendingRatio() const;
};

/// By Gauss's rule with four points a cell; points at which one of both has no normal do not count.
[[nodiscard]] ShapeMeasures measureShape(const PairedSurfaces& surfaces, std::size_t patch);

} // namespace qm
