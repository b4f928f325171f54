/// \file The largest distance between surfaces and their reference, certain to within a few per cent.
#pragma once

#include "bspline/measure/paired_surfaces.h"
#include "bspline/measure/samples.h"

#include <cstddef>
#include <vector>

namespace qm {

/// The distance between a patch and its reference in both directions: no point of either is farther from the
/// other than `upper`, and at one point the search found a distance of `lower`.
struct CertifiedDeviation {
    double upper = 0;
    double lower = 0;
    LayoutPlace place; ///< where `lower` was found
    Samples samples;   ///< four per cell, weighted by their area of parameters

    /// Takes note of a distance that was found at a point.
    void raise(double distance, const LayoutPlace& at);
};

struct CertificationOptions {
    double closing = 0.02;   ///< the search ends once `upper` is within this share of `lower`,
    double negligible = 0;   ///< or below this,
    std::size_t effort = 64; ///< or after this number of steps per cell, and 1000 more

    [[nodiscard]] std::size_t stepsFor(std::size_t cells) const { return 1000 + effort * cells; }
    /// The largest upper bound that is close enough to a lower one.
    [[nodiscard]] double enoughFor(double lower) const;
};

/// Branch and bound over the cells of a patch. Every cell is first bounded by the Bezier net of the
/// difference at equal parameters, which holds in both directions. Only the cells that may contain the
/// maximum are divided further, with the surfaces sliding along one another (`DistanceBound`).
[[nodiscard]] CertifiedDeviation certifiedDeviation(const PairedSurfaces& surfaces, std::size_t patch,
                                                    const CertificationOptions& options);

/// The same for all patches. The largest `upper` of all is as close as the options ask; that of a single
/// patch may also be too large by half of the largest of all, which takes a fraction of the time.
[[nodiscard]] std::vector<CertifiedDeviation>
certifiedDeviations(const PairedSurfaces& surfaces, const CertificationOptions& options, unsigned jobs);

} // namespace qm
