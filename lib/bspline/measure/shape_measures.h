/// \file Compares the normals and curvatures of a surface with those of its reference.
#pragma once

#include "bspline/measure/paired_surfaces.h"

#include <array>
#include <cstddef>

namespace qm {

struct ShapeMeasures {
    double largestNormalDeviation = 0; ///< degrees
    /// Squared angle between the normals, in square degrees, integrated over the parameters.
    double squaredNormalDeviation = 0;
    double area = 0; ///< of the parameters
    /// The integral of the squares of both principal curvatures, of the surface and of the reference;
    /// dimensionless.
    std::array<double, 2> bending{};

    void add(const ShapeMeasures& other);
    [[nodiscard]] double rmsNormalDeviation() const;
    /// The bending of the surface relative to that of the reference; 1 if both are plane.
    [[nodiscard]] double bendingRatio() const;
};

/// Integrates by Gauss's rule with four points per cell; points without a normal on either surface are left
/// out.
[[nodiscard]] ShapeMeasures measureShape(const PairedSurfaces& surfaces, std::size_t patch);

} // namespace qm
