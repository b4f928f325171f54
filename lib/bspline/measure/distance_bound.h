/// \file Upper and lower bounds of the distance of a part of one surface from the other.
#pragma once

#include "bspline/measure/box_pieces.h"
#include "bspline/measure/covering_bound.h"
#include "bspline/measure/foot_search.h"
#include "bspline/measure/paired_surfaces.h"

#include <array>
#include <cstddef>

namespace qm {

/// A box in a cell of one surface, with the place of the other surface that is nearest to the box's middle.
struct SurfacePart {
    std::size_t surface = 0;
    bool isDirected = false; ///< otherwise it stands for the boxes of both surfaces at equal parameters
    Cell cell;
    std::array<double, 2> from{0, 0}; ///< within the cell, whose parameters run from 0 to 1
    std::array<double, 2> to{1, 1};
    /// Where to divide it, if possible so that each side is near one cell of the other surface.
    std::array<double, 2> division{0.5, 0.5};
    Foot foot{};      ///< nearest place on the other surface to the middle
    double upper = 0; ///< no point of the box is farther from the other surface
};

/// Bounds distances by pairing points of the two surfaces: any pairing gives an upper bound.
///
/// A box is paired with a box of one cell of the other surface, whose middle is the foot of its own middle
/// and whose extent makes both move at the same speed; the bound is the largest point of the difference's
/// Bezier net. In a second pairing every point also slides along the other surface by the tangential part of
/// the difference, measured at the foot. The difference along the normal remains, and the slide times the
/// variation of the tangents. Both bounds converge as boxes get smaller. Where surfaces are nearly plane,
/// `CoveringBound` closes at once.
///
/// Reuses its memory, so every thread needs its own.
class DistanceBound {
public:
    explicit DistanceBound(const PairedSurfaces& surfaces)
        : surfaces_(surfaces), search_(surfaces), covering_(surfaces), pieces_(surfaces), ownCell_(surfaces),
          otherCell_(surfaces) {}

    /// Finds the foot, starting from that of `part`, and lowers the upper bound if possible.
    /// \param surprising  a foot farther away than this is searched again from the same parameters
    /// \param enough      once the bound is as low as this, the costlier ones are not tried
    void tighten(SurfacePart& part, double surprising, double enough);

    /// The parameters of a box's middle.
    [[nodiscard]] LayoutPlace middle(const SurfacePart& part) const;

    [[nodiscard]] FootSearch& search() { return search_; }

private:
    /// The middle of a box of the own surface.
    struct BoxMiddle {
        PiecePoint here;              ///< with derivatives by the parameters of the patch
        std::array<double, 2> half{}; ///< of the box's extent, in these parameters
    };
    /// Restricts the own surface to a box.
    [[nodiscard]] BoxMiddle takeOwn(const SurfacePart& part);
    void findFoot(const Eigen::Vector3d& ofMiddle, double surprising, SurfacePart& part);
    /// Subtracts a box of the other surface around the foot, and finds where to divide.
    /// \return the other box
    ParameterBox pairWithOther(const BoxMiddle& own, SurfacePart& part);
    [[nodiscard]] double slidingBound(std::size_t surface, const Foot& foot, const ParameterBox& box,
                                      double known);
    [[nodiscard]] double tangentVariation(std::size_t surface, const Foot& foot, const ParameterBox& touched);

    const PairedSurfaces& surfaces_;
    FootSearch search_;
    CoveringBound covering_;
    BoxPieces pieces_;
    LastPiece ownCell_;
    LastPiece otherCell_;
    BezierPiece own_;
    BezierPiece difference_; ///< with the directions of the other surface's parameters
};

} // namespace qm
