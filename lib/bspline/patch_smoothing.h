/// \file A finished patch with normals nearer to prescribed ones.
#pragma once

#include "bspline/patch_fit.h"

#include <optional>

namespace qm {

/// How far normals are off the prescribed ones. The squares are summed up, so that no angle stays large.
struct NormalErrors {
    double squares = 0;
    double largest = 0;        ///< degrees
    std::size_t direction = 0; ///< of the border on which the largest one is
    std::size_t end = 0;
    double at = 0; ///< its parameter along the border
};

[[nodiscard]] NormalErrors normalErrors(const PatchFitInput& input, const Patch& patch);

struct SmoothedPatch {
    std::optional<Patch> sameKnots;   ///< if the normals come nearer
    std::optional<Patch> oneMoreKnot; ///< if it is allowed, needed and of use
    double gain = 0;                  ///< of each control point that the knot takes
};

/// Patches within the tolerance, as the input's samples tell it, whose normals on the border are nearer to
/// the input's than those of a known patch; both none if no angle between them is larger than `enough`,
/// in degrees. The additional knot lies beside the border or along it, whichever gains more.
[[nodiscard]] SmoothedPatch smoothPatch(const PatchFitInput& input, double tolerance, const Patch& known,
                                        double enough, bool mayGrow);

} // namespace qm
