/// \file An upper bound of the distance of a box of one surface from the other, by heights over a plane.
#pragma once

#include "bspline/measure/box_pieces.h"
#include "bspline/measure/foot_search.h"
#include "bspline/measure/paired_surfaces.h"

#include <cstddef>

namespace qm {

/// Seen along the normal at a foot, a rectangle of the other surface covers the box if each of its sides lies
/// beyond the corresponding side of the box, by the theorem of Poincare and Miranda
/// (docs/METHOD.md#kulpa-1997), whatever the parametrisations are; then only heights differ. The rectangle
/// may continue in the patch beyond a border. The bound is exact at once where both surfaces are plane; where
/// they bend, the pairings of `DistanceBound` are better. Reuses its memory, so every thread needs its own.
class CoveringBound {
public:
    explicit CoveringBound(const PairedSurfaces& surfaces) : pieces_(surfaces) {}

    /// \param box      of the one surface, as one polynomial
    /// \param surface  number of the other surface
    /// \param foot     of the box's middle, on the other surface
    /// \param known    a bound that is known already
    /// \return the bound, or `known` if that is smaller
    [[nodiscard]] double operator()(const BezierPiece& box, std::size_t surface, const Foot& foot,
                                    double known);

private:
    BoxPieces pieces_;
};

} // namespace qm
