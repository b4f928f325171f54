/// \file How far a patch is from the reference, at the points of its lattice.
#pragma once

#include "bspline/fitting/fit_lattice.h"
#include "bspline/splines/surfaces.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// By point of a patch's lattice, in tolerances.
struct PatchErrors {
    std::vector<double> signedDistance; ///< 1 and -1 are just allowed
    std::vector<double> error;          ///< its magnitude; where the patch is folded, at least 2

    [[nodiscard]] double max() const;
    [[nodiscard]] double maxDistance() const; ///< whether the patch is folded or not
};

/// How far the points of a patch are from the reference's points with the same parameters, not counting what
/// it may slide along the reference.
/// \param scale  how much the distances count
[[nodiscard]] PatchErrors latticeErrors(const FitLattice& lattice, const Patch& patch, double tolerance,
                                        double scale = 1);

/// The distance from the reference that an offset from one of its lattice points makes.
[[nodiscard]] double distance(const FitLattice& lattice, std::size_t point, const Point& offset);

/// Moves the targets to where the patch is, but on the reference, and ahead in the direction in which they
/// moved: the parameters of the reference are a choice, and a surface that is not bound to them is smoother
/// and has fewer knots. Where the patch is folded the targets go back to the reference's points: the
/// second time for good.
/// So far off the reference as `slack` tells, less where the emphasis has grown, targets follow the patch
/// along the normal as well, but for creases: what is near enough need not be nearer, and may be fairer
/// instead. Only what differs from the mean distance of the whole patch is followed: plates would make round
/// parts smaller otherwise.
/// Tangent-distance minimisation (docs/METHOD.md#wang-2006), accelerated (docs/METHOD.md#nesterov-1983).
void slideTargets(const Patch& patch, double slack, FitLattice& lattice);

} // namespace qm
