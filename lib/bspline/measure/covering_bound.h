/// \file How far a box of one surface is from the other at most, by heights over a plane.
#pragma once

#include "bspline/measure/box_pieces.h"
#include "bspline/measure/foot_search.h"
#include "bspline/measure/paired_surfaces.h"

#include <Eigen/Core>

#include <cstddef>

namespace qm {

/// Seen along the normal at a foot, a rectangle of the other surface around it covers the box if each of its
/// sides lies beyond the same side of the box: by the theorem of Poincare and Miranda
/// (docs/METHOD.md#kulpa-1997), however both are parametrised. What differs are heights. Where both surfaces
/// are plane this is exact at once; it loses against `DistanceBound`'s pairings where they bend.
///
/// Keeps memory, so one thread uses one.
class CoveringBound {
public:
    explicit CoveringBound(const PairedSurfaces& surfaces) : surfaces_(surfaces), pieces_(surfaces) {}

    /// \param box      of the one surface, as a polynomial
    /// \param surface  the other one
    /// \param foot     on it, of the box's middle
    /// \param known    a bound; larger ones are of no use
    /// \return a bound, `known` if there is none below
    [[nodiscard]] double operator()(const BezierPiece& box, std::size_t surface, const Foot& foot,
                                    double known);

private:
    [[nodiscard]] Eigen::Vector3d pointAt(std::size_t surface, const LayoutPlace& place);

    const PairedSurfaces& surfaces_;
    BoxPieces pieces_;
    BezierPiece cell_;
};

} // namespace qm
