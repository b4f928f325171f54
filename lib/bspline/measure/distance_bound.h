/// \file How far a part of one surface is from the other at most, and at least.
#pragma once

#include "bspline/measure/box_pieces.h"
#include "bspline/measure/covering_bound.h"
#include "bspline/measure/foot_search.h"
#include "bspline/measure/paired_surfaces.h"

#include <array>
#include <cstddef>

namespace qm {

/// A box of one surface's cell, with the place of the other surface that its middle is nearest to.
struct SurfacePart {
    std::size_t surface = 0;
    bool isDirected = false; ///< else it stands for both surfaces' boxes, at equal parameters
    Cell cell;
    std::array<double, 2> from{0, 0}; ///< within the cell, taken as the unit square
    std::array<double, 2> to{1, 1};
    /// Where to divide it: what lies on either side is near one cell of the other surface, if possible.
    std::array<double, 2> division{0.5, 0.5};
    Foot foot{};      ///< of the middle on the other surface
    double upper = 0; ///< no point of the box is farther from the other surface
};

/// Bounds distances by pairing points of the two surfaces: any pairing gives an upper bound.
///
/// A box is paired with a box of one cell of the other surface whose middle is the foot of its own middle and
/// whose sides have the lengths that make both run at the same speed; the largest point of the difference's
/// Bezier net is the bound. In a second pairing every point then slides along the other surface by what the
/// difference has along its tangents at the foot. What remains is the difference along the normal, and the
/// slide times the variation of the tangents over all that it touches. Both close as boxes get smaller. Where
/// surfaces are nearly plane, `CoveringBound` does so at once.
///
/// Keeps memory, so one thread uses one.
class DistanceBound {
public:
    explicit DistanceBound(const PairedSurfaces& surfaces)
        : surfaces_(surfaces), search_(surfaces), covering_(surfaces), pieces_(surfaces) {}

    /// Finds the foot, starting at the one that `part` has, and lowers the upper bound where it can.
    /// \param surprising  a foot farther away than this is searched again, from the same parameters
    void tighten(SurfacePart& part, double surprising);

    /// The parameters of a box's middle.
    [[nodiscard]] LayoutPlace middle(const SurfacePart& part) const;

    [[nodiscard]] FootSearch& search() { return search_; }

private:
    void subtractOther(int turns);
    [[nodiscard]] double slidingBound(std::size_t surface, const Foot& foot, const ParameterBox& box,
                                      double known);
    [[nodiscard]] double tangentVariation(std::size_t surface, const Foot& foot, const ParameterBox& touched);

    const PairedSurfaces& surfaces_;
    FootSearch search_;
    CoveringBound covering_;
    BoxPieces pieces_;
    BezierPiece cell_;
    BezierPiece own_;
    BezierPiece other_;
    BezierPiece difference_; ///< in the other surface's directions
};

} // namespace qm
