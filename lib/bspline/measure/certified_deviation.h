/// \file The largest distance between surfaces and their reference, certain to a few per cent.
#pragma once

#include "bspline/measure/paired_surfaces.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace qm {

/// Distances of a patch from its reference, both ways: no point of either is farther from the other than
/// `upper`, and at one the search found none nearer than `lower`.
struct CertifiedDeviation {
    double upper = 0;
    double lower = 0;
    LayoutPlace place; ///< where `lower` was found
    double rms = 0;    ///< over four samples a cell, by their parameters' area
    /// Distances at these samples, with that area.
    std::vector<std::pair<double, double>> samples;
};

struct CertificationOptions {
    double closing = 0.02;   ///< `upper` is to be within this share of `lower`,
    double negligible = 0;   ///< or at most this,
    std::size_t effort = 16; ///< unless that takes more looks than this a cell, and 1000
};

/// Branch and bound over the cells of a patch. First every cell is bounded by the Bezier net of the
/// difference at equal parameters, which holds for both ways at once; only the cells that can hold the
/// maximum are looked at more closely, with the surfaces sliding along one another (`DistanceBound`).
[[nodiscard]] CertifiedDeviation certifiedDeviation(const PairedSurfaces& surfaces, std::size_t patch,
                                                    const CertificationOptions& options);

/// Of all patches. The largest of all `upper` is as close as the options say; that of a patch may also be as
/// much as half of the largest, which takes a fraction of the time.
[[nodiscard]] std::vector<CertifiedDeviation>
certifiedDeviations(const PairedSurfaces& surfaces, const CertificationOptions& options, unsigned jobs);

/// Root of the mean of the squares, and the smallest distance that at least 95 of 100 parts of the area do
/// not exceed.
[[nodiscard]] double rootMeanSquare(const std::vector<std::pair<double, double>>& samples);
[[nodiscard]] double percentile95(std::vector<std::pair<double, double>> samples);

} // namespace qm
