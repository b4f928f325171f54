/// \file Whether a simple shape is what points with normals show.
#pragma once

#include "export/simple/patch_cloud.h"
#include "export/simple/simple_shape.h"

#include <optional>

namespace qm {

/// Largest angles between the normals of patches and of what takes their place, in degrees.
struct WaveLimits {
    double rms = 3;      ///< root mean square: with more, another shape is meant
    double largest = 10; ///< fits wave within their tolerance, most of all at rims and where facets were
    /// Patches that are plane wave little, and hardly any of those that differ by more has an outline in a
    /// plane.
    double largestOfPlane = 3;
};

/// Of all patches inside their creases together: there is nothing else that they could be.
constexpr WaveLimits ofWholeComponents{6, 20, 6};

/// Largest radius, in sizes of a patch or region: larger arcs look flat, and where their axes lie depends on
/// rounding errors.
constexpr double maxRadius = 10;

/// \return 1, or -1 if the shape's normals point the other way than the points'
[[nodiscard]] int sideOf(const SimpleShape& shape, const OrientedPoints& samples);

/// Whether the shape lies along the points, on this side of all of them: within the tolerance, and with
/// normals within the limits.
[[nodiscard]] bool isAlong(const SimpleShape& shape, int side, const OrientedPoints& samples,
                           double tolerance, const WaveLimits& limits = {});

/// The largest distance of a point.
[[nodiscard]] double farthest(const SimpleShape& shape, const OrientedPoints& samples);

/// The best shape of a kind, if it lies along the points.
/// \param tolerance  in the unit of the points
[[nodiscard]] std::optional<SimpleShape> fittingShape(SimpleKind kind, const OrientedPoints& samples,
                                                      double tolerance, const WaveLimits& limits = {});

/// Whether a shape is a plane, or clearly nearer to the points than a plane is. What bends less is within the
/// tolerance of many surfaces, none of which is meant.
/// \param samples  of unit size
[[nodiscard]] bool isMeant(const SimpleShape& shape, const OrientedPoints& samples);

} // namespace qm
