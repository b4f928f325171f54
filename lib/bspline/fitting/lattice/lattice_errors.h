/// \file The distances between a patch and the reference at the points of its lattice.
#pragma once

#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/splines/surfaces.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Errors in tolerances, by lattice point.
struct PatchErrors {
    /// Signed along the normal of smooth points only; magnitudes up to 1 are within the tolerance.
    std::vector<double> signedDistance;
    std::vector<double> error;  ///< magnitude of the distance; at least 2 where the patch is folded
    std::vector<bool> isFolded; ///< where the patch is folded, and that has not been given up

    [[nodiscard]] double max() const;
    [[nodiscard]] double maxDistance() const; ///< of all points, folded or not
    [[nodiscard]] bool anyFolded() const;
};

/// The distances between the points of a patch and the reference's points with the same parameters, not
/// counting the components along which the patch may slide.
/// \param scale  factor of all distances
[[nodiscard]] PatchErrors latticeErrors(const FitLattice& lattice, const Patch& patch, double tolerance,
                                        double scale = 1);

/// The length of those components of an offset from a lattice point along which the patch may not slide.
[[nodiscard]] double distance(const FitLattice& lattice, std::size_t point, const Point& offset);

/// Moves the targets along the reference to where the patch is, and on in the direction in which they moved.
/// The parametrisation of the reference is arbitrary, and a surface that is not bound to it is smoother and
/// needs fewer knots. Where the patch is folded, targets return to the reference's points; the second time
/// they stay there. Except at creases, targets also follow the patch along the normal, by `slack` at most, or
/// less where the emphasis has grown: a surface that is near enough may be fairer instead of nearer. They
/// follow only deviations from the mean distance of the whole patch, since the plates would otherwise shrink
/// round parts. Tangent-distance minimisation (docs/METHOD.md#wang-2006), accelerated
/// (docs/METHOD.md#nesterov-1983).
/// \param slack  in the unit of the reference
void slideTargets(const Patch& patch, double slack, FitLattice& lattice);

} // namespace qm
