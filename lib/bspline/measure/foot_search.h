/// \file The nearest place of a surface, searched from a place that is near.
#pragma once

#include "bspline/measure/paired_surfaces.h"

#include <Eigen/Geometry>

#include <cstddef>

namespace qm {

struct Foot {
    LayoutPlace place;
    int turns = 0; ///< counter-clockwise quarters from directions at the start to those of the place's patch
    double distance = 0;
    Eigen::Vector3d du{0, 0, 0}; ///< of the surface there, by the parameters of its patch
    Eigen::Vector3d dv{0, 0, 0};
};

/// The Gauss-Newton iteration, over borders into neighbouring patches as well. Keeps the polynomial it used
/// last, so one thread uses one.
class FootSearch {
public:
    explicit FootSearch(const PairedSurfaces& surfaces) : surfaces_(surfaces) {}

    /// The nearest place that it finds; where that is not the nearest one, the distance is too large.
    [[nodiscard]] Foot operator()(std::size_t surface, const LayoutPlace& start,
                                  const Eigen::Vector3d& point);

private:
    /// From a start to the nearest place around, over at most so many borders.
    /// \param crossings  leaves how many may still be crossed
    [[nodiscard]] Foot walk(std::size_t surface, const LayoutPlace& start, const Eigen::Vector3d& point,
                            int& crossings);
    [[nodiscard]] PiecePoint evaluateAt(std::size_t surface, const LayoutPlace& place);

    const PairedSurfaces& surfaces_;
    BezierPiece piece_;
    Cell cell_{static_cast<std::size_t>(-1), {}};
    std::size_t surface_ = 0;
};

} // namespace qm
