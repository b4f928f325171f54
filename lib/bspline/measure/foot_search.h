/// \file Finds the nearest place of a surface from a starting place.
#pragma once

#include "bspline/measure/paired_surfaces.h"

#include <Eigen/Geometry>

#include <cstddef>

namespace qm {

struct Foot {
    LayoutPlace place;
    int turns = 0; ///< counter-clockwise quarter turns from the directions of the start's patch to those of
                   ///< the place's patch
    double distance = 0;
    Eigen::Vector3d position{0, 0, 0}; ///< of the place, and derivatives by the parameters of its patch
    Eigen::Vector3d du{0, 0, 0};
    Eigen::Vector3d dv{0, 0, 0};
};

/// Gauss-Newton iteration that continues across borders into neighbouring patches. It keeps the polynomial
/// that it used last, so every thread needs its own.
class FootSearch {
public:
    explicit FootSearch(const PairedSurfaces& surfaces) : surfaces_(surfaces), piece_(surfaces) {}

    /// Finds a nearest place; if that is only a local minimum, the distance is too large.
    [[nodiscard]] Foot operator()(std::size_t surface, const LayoutPlace& start,
                                  const Eigen::Vector3d& point);

    /// Point of a surface, and derivatives by the parameters of its patch.
    [[nodiscard]] PiecePoint evaluateAt(std::size_t surface, const LayoutPlace& place);

private:
    /// Walks from a start to the nearest place around it.
    /// \param crossings  number of borders that may still be crossed; reduced by those that were
    [[nodiscard]] Foot walk(std::size_t surface, const LayoutPlace& start, const Eigen::Vector3d& point,
                            int& crossings);

    const PairedSurfaces& surfaces_;
    LastPiece piece_;
};

} // namespace qm
