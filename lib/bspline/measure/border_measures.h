/// \file How well neighbouring patches meet, and how smooth a patch is at its own knot lines.
#pragma once

#include "bspline/network/borders.h"
#include "bspline/splines/evaluate.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <array>
#include <vector>

namespace qm {

/// The point of a patch at a distance from the beginning of one of its edges, as it walks it.
[[nodiscard]] SurfacePoint pointAt(const Layout& layout, const std::vector<Patch>& patches,
                                   const BorderPlace& place, double along);

/// The points of both patches of an edge at a distance from its beginning, as the first one walks it.
[[nodiscard]] std::array<SurfacePoint, 2> pointsOnBothSides(const Layout& layout,
                                                            const std::vector<Patch>& patches,
                                                            const BorderEdge& border, double along);

/// Measurements along one edge of the layout, or along the lines within a patch.
struct MeetingMeasures {
    double gap = 0;             ///< largest distance between corresponding points
    std::vector<double> angles; ///< between the normals on both sides, degrees, by sample
};

/// Measures at equally spaced samples from one end of the edge to the other. The first and last angles are
/// taken 1/200 of the edge away from its ends, where a patch may have no normal. An edge on the mesh boundary
/// has no measurements.
/// \param samples  at least 2
[[nodiscard]] MeetingMeasures measureBorder(const BorderEdge& border, const Layout& layout,
                                            const std::vector<Patch>& patches, int samples);

/// Measures along the knot lines of a patch with so high a multiplicity that its tangents may jump.
/// \param samples  per unit of the parameter along the line
[[nodiscard]] MeetingMeasures measureInnerLines(const Patch& patch, int samples);

} // namespace qm
